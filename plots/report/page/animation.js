'use strict';
(() => {
const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const reducedMotion = window.matchMedia('(prefers-reduced-motion: reduce)');
const four = number => String(Number(number.toPrecision(4)));

// Base-64 digits hold five bits each, the lowest first; the sixth bit says that more digits follow. The lowest bit of
// the number is its sign.
function numbersOf(text, count) {
  const numbers = new Int32Array(count);
  let at = 0;
  for (let index = 0; index < count; ++index) {
    let value = 0, shift = 0, digit;
    do {
      digit = alphabet.indexOf(text[at++]);
      value |= (digit & 31) << shift;
      shift += 5;
    } while (digit & 32);
    numbers[index] = value & 1 ? -(value >> 1) : value >> 1;
  }
  return numbers;
}

function bringToLife(box) {
  const data = JSON.parse(box.querySelector('script').textContent);
  const frames = data.times.length, moving = data.moving.length;
  if (frames < 2) return;
  const poses = numbersOf(data.poses, 3 * moving * frames);
  for (let index = 3 * moving; index < poses.length; ++index) poses[index] += poses[index - 3 * moving];
  const scene = box.querySelector('.scene'), groups = scene.children;
  const cracks = [...box.querySelectorAll('.crack')].map(line => ({line, from: Number(line.dataset.from)}));
  const bars = box.querySelectorAll('.bar'), forces = box.querySelectorAll('.force');
  const states = numbersOf(data.bars, 6 * bars.length * frames);
  for (let index = 6 * bars.length; index < states.length; ++index) states[index] += states[index - 6 * bars.length];
  const moment = box.querySelector('.moment'), controls = box.querySelector('.controls');
  const [back, play, step] = controls.querySelectorAll('button');
  const scrub = controls.querySelector('input'), speed = controls.querySelector('select');
  const numbers = controls.querySelector('input[type=checkbox]');
  let shown = frames - 1;

  function show(frame) {
    const from = 3 * moving * frame, before = 3 * moving * shown;
    for (let index = 0; index < moving; ++index) {
      const pose = from + 3 * index, old = before + 3 * index;
      const group = groups[data.moving[index]];
      if (poses[pose] !== poses[old] || poses[pose + 1] !== poses[old + 1] || poses[pose + 2] !== poses[old + 2])
        group.setAttribute('transform',
          'translate(' + (data.at[2 * index] + poses[pose] * data.length).toFixed(2) + ' ' +
          (data.at[2 * index + 1] - poses[pose + 1] * data.length).toFixed(2) + ') rotate(' +
          (-poses[pose + 2] * data.angle).toFixed(3) + ')');
      const level = data.levels[moving * frame + index];
      if (level !== data.levels[moving * shown + index]) {
        group.setAttribute('display', level === '-' ? 'none' : 'inline');
        if (level !== '-') group.setAttribute('fill', data.colours[parseInt(level, 16)]);
      }
    }
    for (const {line, from} of cracks)
      if (from <= frame !== from <= shown) line.setAttribute('display', from <= frame ? 'inline' : 'none');
    bars.forEach((bar, index) => {
      const at = 6 * (bars.length * frame + index), text = forces[index];
      const [x1, y1, x2, y2, force, how] = states.subarray(at, at + 6);
      bar.setAttribute('d', 'M' + x1 / 10 + ' ' + y1 / 10 + 'L' + x2 / 10 + ' ' + y2 / 10);
      text.setAttribute('transform', 'translate(' + x1 / 10 + ' ' + y1 / 10 + ') rotate(' + data.tilts[frame] + ')');
      text.textContent = four(force * data.force) + ' ' + data.unit + (how === 1 ? ', yielded' : '');
      for (const part of [bar, text]) {
        part.classList.toggle('yielded', how === 1);
        part.setAttribute('display', how === 2 ? 'none' : 'inline');
      }
    });
    scene.setAttribute('transform', 'rotate(' + [-data.tilts[frame], ...data.pivot].join(' ') + ')');
    shown = frame;
    const tilt = data.tilts.some(Boolean) ? 'tilt ' + four(data.tilts[frame]) + '\u00b0, ' : '';
    moment.textContent = 'time ' + four(data.times[frame]) + ' s, ' + tilt + 'frame ' + (frame + 1) + ' of ' + frames;
    scrub.value = frame;
    scrub.setAttribute('aria-valuetext', moment.textContent);
  }

  let running = 0, clock = 0, then = 0, changed = 0;
  function stop() {
    cancelAnimationFrame(running);
    running = 0;
    play.textContent = 'Play';
  }
  function tick(now) {
    clock += Math.max(0, now - then) / 1000 * Number(speed.value);
    then = now;
    let frame = shown;
    while (frame + 1 < frames && data.times[frame + 1] <= clock) ++frame;
    // Readers who ask for reduced motion see single pictures instead.
    if (frame !== shown && (!reducedMotion.matches || now - changed >= 500)) {
      changed = now;
      show(frame);
    }
    if (shown === frames - 1) stop();
    else running = requestAnimationFrame(tick);
  }
  function start() {
    if (shown === frames - 1) show(0);
    clock = data.times[shown];
    play.textContent = 'Pause';
    running = requestAnimationFrame(now => {
      then = changed = now;
      tick(now);
    });
  }
  function go(frame) {
    stop();
    show(Math.min(Math.max(frame, 0), frames - 1));
  }
  const toggle = () => running ? stop() : start();

  // Speeds 1, 2, 5, 10, ... around the one at which the whole run takes about ten seconds.
  const middle = Math.round(3 * Math.log10((data.times[frames - 1] - data.times[0]) / 10));
  for (let power = middle - 4; power <= middle + 3; ++power) {
    const decade = Math.floor(power / 3);
    const factor = Number([1, 2, 5][power - 3 * decade] + 'e' + decade);
    speed.add(new Option(factor === 1 ? 'real time' : factor + ' \u00d7 real time', factor, power === middle, power === middle));
  }
  scrub.max = frames - 1;
  scrub.value = shown;
  back.addEventListener('click', () => go(shown - 1));
  step.addEventListener('click', () => go(shown + 1));
  play.addEventListener('click', toggle);
  scrub.addEventListener('input', () => go(Number(scrub.value)));
  if (numbers) numbers.addEventListener('change', () => box.classList.toggle('numbered', numbers.checked));
  box.addEventListener('keydown', event => {
    if (event.target === numbers) return;
    if (event.altKey || event.ctrlKey || event.metaKey || event.target === scrub || event.target === speed) return;
    const action = {ArrowLeft: () => go(shown - 1), ArrowRight: () => go(shown + 1), Home: () => go(0),
                    End: () => go(frames - 1), ' ': event.target.tagName === 'BUTTON' ? null : toggle}[event.key];
    if (action) {
      event.preventDefault();
      action();
    }
  });
  box.tabIndex = 0;
  controls.hidden = false;
  show(shown);
}
document.querySelectorAll('.animation').forEach(bringToLife);
})();
