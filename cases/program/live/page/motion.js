// Blocks in motion: a few milliseconds of motion are requested at a time, and drawn in between.
const motion = {blocks: [], centres: [], playing: false, picture: null, rate: 0};
const energies = ['work of gravity and loads', 'kinetic', 'elastic', 'friction', 'damping', 'residual'];
async function beginMotion() {
  find('motion').hidden = false;
  find('answers').hidden = true;
  find('start').addEventListener('click', attempt(() => startMotion()));
  find('play').addEventListener('click', () => { motion.playing ? pause() : play(); });
  find('step').addEventListener('click', attempt(async () => { pause(); take(await ask('/motion/step', {steps: 1})); }));
  find('forces').addEventListener('change', drawBlocks);
  await startMotion();
}

// `answer` holds the points that can be dragged; without it they are requested.
async function startMotion(answer) {
  pause();
  tell('The static start is being found.');
  const made = await ask('/motion/start', {values: state.values});
  motion.handles = (answer?.handles ? answer : await ask('/answer', {values: state.values})).handles;
  Object.assign(motion, {blocks: made.blocks, centres: made.centres, tilt: made.tilt, mass: made.mass});
  take(await ask('/motion/step', {steps: 0}));
  showHandles();
  tell('');
}

// Shows the points of the section above the blocks, as long as the blocks are where the case has them.
function showHandles() {
  const canvas = find('blocks'), handles = svg('svg', {id: 'handles', viewBox: `0 0 ${canvas.width} ${canvas.height}`, role: 'group', 'aria-label': 'Points of the section'});
  handles.ranges = true;  // the view stays while one is dragged
  handles.toPicture = viewOf(canvas);
  const [x0, y0] = handles.toPicture([0, 0]), [ax, ay] = handles.toPicture([1, 0]), [bx, by] = handles.toPicture([0, 1]);
  const toData = new DOMMatrix([ax - x0, ay - y0, bx - x0, by - y0, x0, y0]).inverse();
  handles.toData = (x, y) => { const at = new DOMPoint(x, y).matrixTransform(toData); return [at.x, at.y]; };
  handles.classList.toggle('moving', motion.picture.steps > 0);
  addHandles(handles, motion);
  find('handles').replaceWith(handles);
  if (state.focus) handles.querySelector(`[data-name="${CSS.escape(state.focus)}"]`)?.focus();
}

async function changeMotion(answer) {
  if (!motion.picture.steps) { await startMotion(answer); return; }  // the static start is another one
  try {
    await ask('/motion/change', {values: state.values});
  } catch (error) {
    await startMotion(answer);
    return;
  }
  motion.handles = (answer?.handles ? answer : await ask('/answer', {values: state.values})).handles;
  showHandles();
  drawBlocks();
}

// A variant keeps a picture of its blocks in their positions at that time.
const pictureOfMotion = () => ({image: find('blocks').toDataURL(), verdict: find('verdict').textContent, clock: `${motion.picture.time.toFixed(3)} s`});

function showBesideMotion() {
  const name = find('beside').value, beside = state.variants.get(name);
  find('return').disabled = !beside;
  if (!beside) { find('sections').replaceChildren(); return; }
  const box = document.createElement('figure'), {image, verdict, clock} = beside.motion;
  box.append(Object.assign(document.createElement('img'), {src: image, alt: `Blocks of ${name}`}),
    Object.assign(document.createElement('figcaption'), {textContent: `${name}, after ${clock}: ${verdict}`}));
  find('sections').replaceChildren(box);
}

function take(buffer) {
  const numbers = new Float32Array(buffer);
  const [time, stepsAbove, stepsBelow, verdict, onset] = numbers, [blocks, forces] = numbers.slice(12, 14);
  const steps = stepsAbove * 2 ** 24 + stepsBelow, balance = [...numbers.slice(5, 11)], first = 15, next = first + 3 * blocks;
  motion.picture = {time, steps, onset, unbalanced: numbers[11], poses: numbers.subarray(first, next),
    forces: numbers.subarray(next, next + 4 * forces), bolts: numbers.subarray(next + 4 * forces)};
  find('clock').textContent = `${time.toFixed(3)} s, ${steps} steps${motion.rate ? `, ${motion.rate.toFixed(0)} pictures a second` : ''}`;
  if (verdict !== motion.decided) {
    motion.decided = verdict;
    motion.said = null;
    if (verdict) askVerdict(verdict);
  }
  showVerdict();
  // Below a millionth of the greatest energy a single float holds only rounding, as below a millionth of a joule.
  const most = Math.max(1, ...balance.map(Math.abs));
  find('energy').tBodies[0].replaceChildren(...energies.map((name, index) => {
    const row = document.createElement('tr');
    row.insertCell().textContent = name;
    const cell = row.insertCell();
    cell.className = 'number';
    cell.textContent = `${Math.abs(balance[index]) < most * 1e-6 ? 0 : (balance[index] / 1000).toPrecision(4)} kJ/m`;
    return row;
  }));
  find('handles').classList.toggle('moving', steps > 0);
  drawBlocks();
}

// Asks how a run of the case would have ended, in the words of its report.
const askVerdict = verdict => attempt(async () => {
  const said = await ask('/motion/verdict');
  if (motion.decided !== verdict) return;
  motion.said = said;
  if (said.over) pause();
  showVerdict();
})();

function showVerdict() {
  const {steps, onset, unbalanced} = motion.picture;
  find('verdict').textContent = (motion.said?.verdict || (!steps ? 'At the start: Play sets the blocks in motion.'
    : onset >= 0 ? `In motion: the first block passed the thresholds of failure at ${onset.toPrecision(3)} s.`
    : 'In motion: neither at rest nor failed yet.'));
  const percent = 100 * unbalanced;
  const force = percent < 1e-6 ? 'none' : percent > 100 ? "more than a block's load" : `${percent.toPrecision(3)} % of a block's load`;
  showSentences([...(motion.said?.sentences || []), `Greatest unbalanced force now: ${force}.`]);
}

// The view has gravity downwards, and is half as large again as the free blocks, so that they have room to move.
function viewOf(canvas) {
  if (state.ranges) return motion.view;
  const cosine = Math.cos(motion.tilt), sine = Math.sin(motion.tilt);
  const upright = ([x, y]) => [cosine * x - sine * y, sine * x + cosine * y];
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const block of motion.blocks)
    for (const corner of block.fixed ? [] : block.outline.map(upright))
      for (const axis of [0, 1]) {
        low[axis] = Math.min(low[axis], corner[axis]);
        high[axis] = Math.max(high[axis], corner[axis]);
      }
  const scale = Math.min(canvas.width / (high[0] - low[0]), canvas.height / (high[1] - low[1])) / 1.5;
  return motion.view = point => {
    const [x, y] = upright(point);
    return [canvas.width / 2 + scale * (x - (low[0] + high[0]) / 2), canvas.height / 2 - scale * (y - (low[1] + high[1]) / 2)];
  };
}

function drawBlocks() {
  const canvas = find('blocks'), pen = canvas.getContext('2d'), {poses, forces, bolts} = motion.picture;
  const style = getComputedStyle(document.documentElement), paint = name => style.getPropertyValue('--' + name);
  const toPicture = viewOf(canvas);
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.lineWidth = 1;
  pen.strokeStyle = paint('ink');
  for (const fixed of [true, false]) {
    pen.fillStyle = paint(fixed ? 'rock' : 'panel');
    motion.blocks.forEach((block, number) => {
      if (block.fixed !== fixed) return;
      pen.beginPath();  // one path of all blocks would be filled three times as slowly
      const [dx, dy, angle] = poses.subarray(3 * number, 3 * number + 3), cosine = Math.cos(angle), sine = Math.sin(angle);
      const [cx, cy] = motion.centres[number];
      block.outline.forEach(([x, y], corner) => {
        const [px, py] = toPicture([cx + dx + cosine * (x - cx) - sine * (y - cy), cy + dy + sine * (x - cx) + cosine * (y - cy)]);
        corner ? pen.lineTo(px, py) : pen.moveTo(px, py);
      });
      pen.closePath();
      pen.fill();
      pen.stroke();
    });
  }
  drawWater(pen, paint, toPicture);
  drawBolts(pen, bolts, paint, toPicture);
  if (!find('forces').checked) return;
  let greatest = 0;
  for (let at = 0; at < forces.length; at += 4) greatest = Math.max(greatest, Math.hypot(forces[at + 2], forces[at + 3]));
  if (greatest < 0.01 * motion.mass) return;  // a thousandth of a block's weight: nothing has come to bear yet
  // Lines of one width are drawn at once: thousands of single strokes would take three times as long.
  const widths = Array.from({length: 17}, () => new Path2D());
  for (let at = 0; at < forces.length; at += 4) {
    const x = forces[at], y = forces[at + 1], fx = forces[at + 2], fy = forces[at + 3], force = Math.hypot(fx, fy);
    if (force < greatest / 200) continue;
    const [px, py] = toPicture([x, y]), [qx, qy] = toPicture([x + fx / force, y + fy / force]);
    const half = 9 / Math.hypot(qx - px, qy - py), lines = widths[Math.ceil(16 * force / greatest)];
    lines.moveTo(px - half * (qx - px), py - half * (qy - py));
    lines.lineTo(px + half * (qx - px), py + half * (qy - py));
  }
  pen.strokeStyle = paint('vermilion');
  widths.forEach((lines, width) => { pen.lineWidth = width / 2; if (width) pen.stroke(lines); });
}

// Draws the present water table of a section.
function drawWater(pen, paint, toPicture) {
  const points = [...state.inputs.keys()].filter(name => /water\.vertex\[\d+\]\.x$/.test(name)).map(name => [name, name.replace(/x$/, 'y')].map(one => valueOf(one) / state.open.metre));
  pen.strokeStyle = paint('sky');
  pen.lineWidth = 3;
  pen.beginPath();
  points.forEach((point, index) => index ? pen.lineTo(...toPicture(point)) : pen.moveTo(...toPicture(point)));
  pen.stroke();
}

// Draws bolts with their tension; those that have yielded are dashed and red.
function drawBolts(pen, bolts, paint, toPicture) {
  pen.font = `${16 * canvasScale()}px system-ui, sans-serif`;  // as shown
  for (let at = 0; at < bolts.length; at += 6) {
    const [x1, y1, x2, y2, force, yielded] = bolts.subarray(at, at + 6), from = toPicture([x1, y1]), to = toPicture([x2, y2]);
    pen.strokeStyle = pen.fillStyle = paint(yielded > 0 ? 'vermilion' : 'blue');
    pen.setLineDash(yielded > 0 ? [9, 6] : []);
    pen.lineWidth = 3;
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(...to);
    pen.stroke();
    pen.textAlign = to[0] < from[0] ? 'right' : 'left';
    pen.fillText(`${(force / 1000).toPrecision(3)} kN/m${yielded > 0 ? ', yielded' : ''}`, from[0], from[1] + canvasScale() * (to[1] < from[1] ? 18 : -6));
  }
  pen.setLineDash([]);
}

const canvasScale = () => find('blocks').width / (find('blocks').clientWidth || 1);

function pause() {
  motion.playing = false;
  find('play').textContent = 'Play';
}

async function play() {
  motion.playing = true;
  find('play').textContent = 'Pause';
  let pictures = 0, since = performance.now();
  const goOn = () => ask('/motion/step', {milliseconds: 20});
  const turn = motion.turn = (motion.turn || 0) + 1;  // one that is started before this one has ended takes over
  let next = goOn();
  while (next) {
    try {
      const buffer = await next;
      next = motion.playing && motion.turn === turn && goOn();  // is computed while this one is drawn
      take(buffer);
    } catch (error) {
      tell(error.message);
      pause();
      next = null;
    }
    await new Promise(requestAnimationFrame);
    ++pictures;
    const now = performance.now();
    if (now - since > 1000) {
      motion.rate = 1000 * pictures / (now - since);
      [pictures, since] = [0, now];
    }
  }
}
