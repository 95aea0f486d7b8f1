// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Animations: which one, where it is, and whether it runs. Where people want less motion it waits for them.

const STEPS = 1000;

export class Player {
  #find;
  #onTime;
  #clips = [];
  #time = 0;
  #last = null; // of the clock, while it runs

  /** `onTime`: gets the number of an animation and the time in it, seconds. */
  constructor(find, onTime) {
    [this.#find, this.#onTime] = [find, onTime];
    find('play').addEventListener('click', () => this.run(this.#last === null));
    find('clip').addEventListener('change', () => this.#go(0));
    find('time').addEventListener('input', () => {
      this.run(false);
      this.#go((find('time').value / STEPS) * this.#clip.duration);
    });
  }

  get #clip() {
    return this.#clips[this.#find('clip').selectedIndex];
  }

  /** `clips`: { name, duration }; none hides the player. */
  show(clips) {
    const find = this.#find;
    this.run(false);
    this.#clips = clips;
    find('player').hidden = clips.length === 0;
    find('clip').replaceChildren(...clips.map(({ name }) => new Option(name)));
    find('clip').hidden = clips.length < 2;
    if (clips.length === 0) return;
    this.#go(0);
    this.run(!matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  run(isRunning) {
    const wasRunning = this.#last !== null;
    this.#last = isRunning ? performance.now() : null;
    this.#find('play').textContent = isRunning ? 'Pause' : 'Play';
    if (isRunning && !wasRunning) requestAnimationFrame((now) => this.#step(now));
  }

  #step(now) {
    if (this.#last === null) return;
    this.#go((this.#time + Math.max(0, now - this.#last) / 1000) % (this.#clip.duration || 1));
    this.#last = now;
    requestAnimationFrame((next) => this.#step(next));
  }

  /** What is shown meanwhile may be new: it takes the same time. */
  again() {
    if (this.#clips.length > 0) this.#go(this.#time);
  }

  #go(time) {
    this.#time = time;
    const { duration } = this.#clip;
    this.#find('time').value = (STEPS * time) / (duration || 1);
    this.#find('time').setAttribute('aria-valuetext', `${time.toFixed(2)} of ${duration.toFixed(2)} s`);
    this.#onTime(this.#find('clip').selectedIndex, time);
  }
}
