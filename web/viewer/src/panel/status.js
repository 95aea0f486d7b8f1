// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What the page does, or what went wrong.
import { Superseded } from '../latest-job.js';

export class Status {
  #find;

  constructor(find) {
    this.#find = find;
  }

  tell(text, isBusy = true) {
    const find = this.#find;
    find('status').textContent = text;
    find('error').textContent = '';
    find('error').hidden = true;
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

  /** Work that was given up for other work is no failure. */
  fail(error) {
    if (error instanceof Superseded) return;
    this.tell('', false);
    document.body.dataset.state = 'failed';
    this.#find('error').textContent = error.message;
    this.#find('error').hidden = false;
  }
}
