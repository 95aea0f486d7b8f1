// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What the page does, or what went wrong.
import { Superseded } from '../latest-job.js';

export class Status {
  #find;
  #keepsFailure = false;

  constructor(find) {
    this.#find = find;
  }

  tell(text, isBusy = true) {
    const find = this.#find;
    find('status').textContent = text;
    if (!this.#keepsFailure) find('error').textContent = '';
    find('error').hidden = !this.#keepsFailure;
    find('progress').style.visibility = isBusy ? 'visible' : 'hidden';
    if (!isBusy && document.activeElement === find('cancel')) find('canvas').focus(); // what is hidden loses it
    find('cancel').hidden = !isBusy;
    find('progress').value = 0;
    document.body.dataset.state = isBusy ? 'busy' : 'done';
  }

  /** `step`: what is done; it is read out where it changes. */
  follow({ step, share }) {
    this.#find('progress').value = share;
    if (this.#find('status').textContent !== step) this.#find('status').textContent = step;
  }

  /** Whether what was last told is that something went wrong; `keepsFailure`: and it is shown while other work is done. */
  get hasFailed() {
    return document.body.dataset.state === 'failed';
  }
  set keepsFailure(keeps) {
    this.#keepsFailure = keeps;
  }

  /** Work that was given up for other work is no failure. */
  fail(error) {
    if (error instanceof Superseded) return;
    this.#keepsFailure = false;
    this.tell('', false);
    document.body.dataset.state = 'failed';
    this.#find('error').textContent = error.message;
    this.#find('error').hidden = false;
  }
}
