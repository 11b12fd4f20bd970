// The case on the page: inputs, answers, handles, map, variants.
const token = location.hash.slice(1);
const find = id => document.getElementById(id);
const state = {values: {}, start: {}, design: null, past: [], future: [], variants: new Map(), inputs: new Map(), answer: null, open: null, width: 0, ranges: null};

function tell(text) {
  find('message').hidden = !text;
  find('message').textContent = text || '';
}

async function ask(path, request) {
  const response = await fetch(path, {method: 'POST', body: JSON.stringify(request || {}),
    headers: {'Content-Type': 'application/json', 'X-Delabole-Token': token}});
  if (response.headers.get('Content-Type') === 'application/octet-stream') return response.arrayBuffer();
  const answer = await response.json();
  if (answer.refused) throw new Error(answer.refused);
  return answer;
}

// Sends one request of a kind at a time, and of those that come meanwhile only the last. The promise resolves when all
// are answered.
function latest(work) {
  let running = null, waiting = null;
  const answerAll = async () => {
    while (waiting) {
      const next = waiting;
      waiting = null;
      try {
        await work(...next);
        tell('');
      } catch (error) {
        tell(error.message);
      }
    }
    running = null;
  };
  return (...now) => {
    waiting = now;
    return running ??= answerAll();
  };
}

const digits = number => Number(Number(number).toPrecision(5));
const valueOf = name => state.values[name] ?? state.inputs.get(name).value;

function sliderRange(input) {
  const scale = input.value ? Math.abs(input.value) : {m: 10, ft: 30, kPa: 100, deg: 45, 'kN/m3': 10, 'kN/m': 100}[input.unit] || 1;
  let lower = input.lower ?? (input.value >= 0 && !/\.(x|y)$/.test(input.name) ? 0 : input.value - 2 * scale);
  let upper = input.upper ?? input.value + 2 * scale;
  if (input.unit !== 'deg' && upper - lower > 6 * scale) {
    lower = Math.max(lower, input.value >= 0 && lower >= 0 ? lower : input.value - 2 * scale);
    upper = Math.min(upper, input.value + 2 * scale);
  }
  const inset = (upper - lower) * 1e-4;
  return [input.lower_open && lower === input.lower ? lower + inset : lower,
    input.upper_open && upper === input.upper ? upper - inset : upper];
}

function buildInputs(groups) {
  let opened = 0;
  groups.forEach(group => {
    const box = document.createElement('details');
    const corner = group.inputs.every(input => /\.(x|y)$/.test(input.name));  // is dragged rather
    box.open = !corner && group.inputs.length < 12 && ++opened <= 6;
    const summary = document.createElement('summary');
    summary.textContent = group.label;
    box.append(summary);
    for (const input of group.inputs) {
      const row = document.createElement('div');
      row.className = 'input';
      row.title = input.meaning + (input.source ? `\nSource: ${input.source}` : '');
      const id = 'input-' + input.name;
      const label = Object.assign(document.createElement('label'), {htmlFor: id, textContent: input.label});
      const slider = Object.assign(document.createElement('input'), {type: 'range', step: 'any'});
      const box2 = Object.assign(document.createElement('input'), {type: 'number', step: 'any', id});
      const unit = Object.assign(document.createElement('span'), {className: 'unit', textContent: input.unit});
      const [lower, upper] = sliderRange(input);
      Object.assign(slider, {min: lower, max: upper});
      slider.setAttribute('aria-label', `${group.label}: ${input.label}${input.unit ? ' in ' + input.unit : ''}`);
      slider.addEventListener('pointerdown', remember);
      slider.addEventListener('keydown', event => { if (!event.repeat && /^(Arrow|Page|Home|End)/.test(event.key)) remember(); });
      slider.addEventListener('input', () => change({[input.name]: digits(slider.value)}));
      box2.addEventListener('change', () => {
        if (box2.value === '') { showInputs(); return; }  // emptied, or not a number: not 0
        remember();
        change({[input.name]: Number(box2.value)});
      });
      row.append(label, slider, box2, unit);
      box.append(row);
      state.inputs.set(input.name, {...input, row, slider, number: box2, group: group.label});
    }
    find('inputs').append(box);
  });
}

function showInputs() {
  for (const [name, input] of state.inputs) {
    const value = valueOf(name);
    if (document.activeElement !== input.slider) input.slider.value = value;
    input.number.value = digits(value);
    input.row.classList.toggle('changed', name in state.values);
    input.slider.setAttribute('aria-valuetext', `${digits(value)} ${input.unit}`);
  }
  find('undo').disabled = !state.past.length;
  find('redo').disabled = !state.future.length;
}

function remember() {
  state.past.push({...state.values});
  state.past.splice(0, state.past.length - 200);
  state.future = [];
}

function set(values) {
  state.values = {};
  for (const [name, value] of Object.entries(values))
    if (value !== state.inputs.get(name).value) state.values[name] = value;
}

function change(values) {
  set({...state.values, ...values});
  showInputs();
  refresh();
}

function goTo(values) {
  set(values);
  showInputs();
  refresh();
}

function step(from, to) {
  if (!from.length) return;
  to.push({...state.values});
  goTo(from.pop());
}

const refresh = latest(async () => {
  if (state.open.moves) { await changeMotion(); return; }
  try {
    show(await ask('/answer', {values: state.values}));
  } catch (error) {
    show({failure: error.message});  // no verdict stands beside inputs that it does not belong to
    return;
  }
  refreshMap();
});

const refreshMap = latest(async () => {
  if (!state.open.map) return;
  const titles = ['across', 'up'].map(id => state.inputs.get(find(id).value));
  const [x, y] = titles.map(input => {
    const [lower, upper] = state.open.fit?.[input.name] || sliderRange(input);
    return {name: input.name, lower, upper};
  });
  if (x.name === y.name) return;
  const asked = {values: state.values, output: state.open.map.output};
  const began = performance.now(), coarse = await ask('/map', {...asked, x, y, columns: 48, rows: 36});
  const closer = closerRange(coarse, [valueOf(x.name), valueOf(y.name)]);
  if (closer) [x, y].forEach((axis, index) => Object.assign(axis, closer[index]));
  // The map is finer if nothing is being dragged and the model is quick.
  const finer = !state.ranges && performance.now() - began < 100 ? 1.5 : 1;
  const map = finer === 1 && !closer ? coarse : await ask('/map', {...asked, x, y, columns: 48 * finer, rows: 36 * finer});
  const axes = titles.map(input => ({title: `${input.group}: ${input.label}`, unit: input.unit, grid: false}));
  const fit = state.open.fit && await ask('/fit', {values: state.values, x, y, columns: 32, rows: 24});
  const picture = drawMap(map, axes, [valueOf(x.name), valueOf(y.name)], find('chart').clientWidth, fit && fit.values && fit);
  find('valley-key').hidden = !(fit && fit.values);
  if (fit) showObservations(fit.observations);
  picture.setAttribute('aria-label', 'Factor of safety over two inputs; a click sets both');
  picture.addEventListener('click', event => {
    const [a, b] = dataAt(picture, event);
    remember();
    change({[x.name]: digits(Math.min(map.x.at(-1), Math.max(map.x[0], a))), [y.name]: digits(Math.min(map.y.at(-1), Math.max(map.y[0], b)))});
  });
  find('chart').replaceChildren(picture);
});

// If more than half of the map has no answer, returns the part around the answers and the present point.
function closerRange(map, here) {
  const cells = map.values.flatMap((row, j) => row.map((value, i) => value === null ? null : [i, j])).filter(Boolean);
  if (!cells.length || 2 * cells.length > map.x.length * map.y.length) return null;
  return [map.x, map.y].map((axis, index) => {
    const places = cells.map(cell => cell[index]), at = place => axis[Math.min(axis.length - 1, Math.max(0, place))];
    return {lower: Math.min(here[index], at(Math.min(...places) - 1)), upper: Math.max(here[index], at(Math.max(...places) + 1))};
  });
}

function showObservations(observations) {
  find('observations').hidden = false;
  find('observations').tBodies[0].replaceChildren(...observations.map(one => {
    const row = document.createElement('tr');
    for (const text of [one.label, `${one.relation} ${one.observed}`, one.predicted || 'not predicted', one.predicted ? one.residual.toFixed(1) : ''])
      row.insertCell().textContent = text;
    return row;
  }));
}

function dataAt(picture, event, toPicture = picture.getScreenCTM().inverse()) {
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(toPicture);
  return picture.toData(place.x, place.y);
}

function addHandles(picture, answer) {
  for (const handle of answer.handles) {
    const place = point => picture.toPicture(point.map(one => one * (answer.metre || 1)));  // points of handles are in metres
    const at = place(handle.at), [least, most] = sliderRange(state.inputs.get(handle.inputs[0])), now = valueOf(handle.inputs[0]);
    const stays = /water/.test(handle.name) ? ' stays' : '';  // of blocks in motion
    if (handle.from) {
      const [x1, y1] = place(handle.from);
      svg('line', {class: 'spoke', x1, y1, x2: at[0], y2: at[1]}, picture);
      const left = at[0] < x1;
      svg('text', {class: 'box', x: at[0] + (left ? -12 : 12), y: at[1] + 4, 'text-anchor': left ? 'end' : 'start'}, picture).textContent = handle.name;
    }
    const drawn = svg('g', {class: `handle${stays}`, tabindex: 0, role: 'slider',
      'aria-label': handle.name, 'aria-valuenow': digits(now), 'aria-valuemin': digits(Math.min(least, now)), 'aria-valuemax': digits(Math.max(most, now)), 'aria-valuetext': handle.inputs.map(name => `${name} ${digits(valueOf(name))} ${state.inputs.get(name).unit}`).join(', ')}, picture);
    svg('title', {}, drawn).textContent = `${handle.name}: ${handle.inputs.join(', ')}`;
    svg('circle', {class: 'finger', cx: at[0], cy: at[1], r: 16}, drawn);
    svg('circle', {cx: at[0], cy: at[1], r: 9}, drawn);
    drawn.dataset.name = handle.name;
    drawn.addEventListener('pointerdown', event => {
      event.preventDefault();
      // Each answer draws the picture anew; until the point is released all pictures have the scales of this one.
      const toPicture = picture.getScreenCTM().inverse();
      const start = {values: {...state.values}, ranges: picture.ranges};
      let dragging = null;
      const move = moved => {
        if (!dragging) remember();
        dragging = drag(handle.name, dataAt(picture, moved, toPicture), answer.metre || 1, handle.is_origin && start);
      };
      const end = async () => {
        window.removeEventListener('pointermove', move);
        window.removeEventListener('pointerup', end);
        await dragging;  // else the slope before the last move would be asked for, and might be answered last
        state.ranges = null;
        refresh();
      };
      state.ranges = picture.ranges;
      window.addEventListener('pointermove', move);
      window.addEventListener('pointerup', end);
    });
    drawn.addEventListener('keydown', event => {
      const by = {ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6]}[event.key];
      if (!by) return;
      event.preventDefault();
      if (!event.repeat) remember();
      state.focus = handle.name;
      drag(handle.name, picture.toData(at[0] + by[0], at[1] + by[1]), answer.metre || 1);
    });
  }
}

// A drag of the origin is measured from `start`: the origin stays under the pointer while the picture is shifted.
const drag = latest(async (handle, to, metre, start) => {
  const answer = await ask('/drag', {values: start ? start.values : state.values, handle, to: to.map(one => one / metre)});
  const goes = start && Object.entries(answer.values).some(([name, value]) => digits(value) !== digits(start.values[name] ?? state.inputs.get(name).value));
  if (start) state.ranges = start.ranges.map((range, axis) => range.map(end => goes ? end - to[axis] : end));
  const values = Object.fromEntries(Object.entries(answer.values).map(([name, value]) => [name, digits(value)]));
  set({...state.values, ...values});
  showInputs();
  if (state.open.moves) { await changeMotion(answer); return; }
  show(answer);
  refreshMap();
});

// Two sections are shown side by side if there is room.
function widthOfSections() {
  const room = find('sections').clientWidth;
  return state.variants.has(find('beside').value) && room > 560 ? room / 2 - 8 : room;
}

function sectionOf(answer, title, withHandles) {
  const box = document.createElement('figure'), figure = answer.figures[0];
  const caption = document.createElement('figcaption');
  caption.textContent = title || (figure && figure.caption) || '';
  if (figure) {
    if (withHandles && state.ranges) [figure.x.range, figure.y.range] = state.ranges;
    const picture = drawFigure(figure, widthOfSections());
    if (withHandles) addHandles(picture, answer);
    box.append(picture, legendOf(figure));
  }
  box.append(caption);
  return box;
}

const keyOf = values => JSON.stringify(Object.entries(values).sort());

// Asks for the support that `delabole run` would design for the slope as it is now.
async function designSupport() {
  const {values, sentence} = await ask('/support', {values: state.values});
  set({...state.values, ...values});
  state.design = {of: keyOf(state.values), sentence};
}

// Returns the sentences of the report; if the support is not the designed one, they say so.
function sentencesOf(answer) {
  const sentences = [...(answer.sentences || [])];
  if (!state.open.designs_support || answer.failure) return sentences;
  const designed = state.design?.of === keyOf(state.values);
  return [designed ? state.design.sentence : 'The support is as set here; "Cheapest support" finds the one that delabole run would choose.', ...sentences].slice(0, 2);
}

function showSentences(sentences) {
  find('sentences').replaceChildren(...sentences.map(text => Object.assign(document.createElement('p'), {textContent: text})));
}

function show(answer) {
  if (answer !== state.answer) find('findings').replaceChildren();
  state.answer = answer;
  find('verdict').textContent = answer.failure || answer.verdict;
  find('verdict').className = answer.failure ? 'failure' : '';
  showSentences(sentencesOf(answer));
  const beside = state.variants.get(find('beside').value);
  find('return').disabled = !beside;
  if (!answer.failure) {
    const sections = [sectionOf(answer, beside ? 'now' : '', true)];
    if (beside) sections.push(sectionOf(beside.answer, `${find('beside').value}: ${beside.answer.failure || beside.answer.verdict}`, false));
    find('sections').replaceChildren(...sections);
    find('sections').querySelectorAll('svg').forEach(spreadLabels);
    if (state.focus) find('sections').querySelector(`[data-name="${CSS.escape(state.focus)}"]`)?.focus();
  } else if (find('sections').firstChild) {
    find('sections').querySelector('figcaption').textContent = 'The slope before this change.';
  }
  find('warnings').replaceChildren(...(answer.warnings || []).map(text => Object.assign(document.createElement('li'), {textContent: text})));
  find('figures').replaceChildren();
  find('more').hidden = !answer.figures?.length;
  find('results').tHead.hidden = !beside || answer.failure;
  find('other').textContent = find('beside').value;
  const other = beside && new Map(beside.answer.results.map(one => [one.name, one]));
  find('results').tBodies[0].replaceChildren(...(answer.results || []).filter(one => !one.detail).map(one => {
    const row = document.createElement('tr');
    row.title = one.meaning;
    row.insertCell().textContent = one.name.replaceAll('_', ' ');
    for (const shown of other ? [one, other.get(one.name)] : [one]) {
      const cell = row.insertCell();
      cell.className = 'number';
      cell.textContent = shown ? shown.text.replaceAll('_', ' ') : '';
    }
    return row;
  }));
}

function addMap() {
  if (!state.open.map) return;
  find('map').hidden = false;
  for (const [id, chosen] of [['across', state.open.map.x], ['up', state.open.map.y]]) {
    find(id).replaceChildren(...[...state.inputs.keys()].map(name => new Option(name, name, false, name === chosen)));
    find(id).addEventListener('change', () => refreshMap());
  }
}

// The study is of the slope at the time of the request; after a change its sentences no longer apply.
function addStudy() {
  find('study').hidden = !state.open.studies;
  find('ask-study').addEventListener('click', attempt(async () => {
    tell('Samples are drawn and fits are made.');
    const values = JSON.stringify(state.values), {sentences} = await ask('/study', {values: state.values});
    tell('');
    if (values === JSON.stringify(state.values))
      find('findings').replaceChildren(...sentences.map(text => Object.assign(document.createElement('li'), {textContent: text})));
  }));
}

function attempt(work) {
  return async () => { try { await work(); } catch (error) { tell(error.message); } };
}

function addTools() {
  find('undo').addEventListener('click', () => step(state.past, state.future));
  find('redo').addEventListener('click', () => step(state.future, state.past));
  find('restore').addEventListener('click', () => { remember(); goTo(state.start); });
  find('design').addEventListener('click', attempt(async () => {
    remember();
    await designSupport();
    showInputs();
    await refresh();
  }));
  find('beside').addEventListener('change', () => state.open.moves ? showBesideMotion() : state.answer && show(state.answer));
  find('return').addEventListener('click', () => { remember(); goTo(state.variants.get(find('beside').value).values); });
  find('keep').addEventListener('click', () => {
    if (!state.open.moves && (!state.answer || state.answer.failure)) return;
    const name = find('name').value.trim() || `variant ${state.variants.size + 1}`;
    if (!state.variants.has(name)) find('beside').add(new Option(name, name));
    state.variants.set(name, {values: {...state.values}, answer: state.answer, motion: state.open.moves && pictureOfMotion()});
    find('beside').value = name;
    find('name').value = '';
    state.open.moves ? showBesideMotion() : show(state.answer);
  });
  find('save').addEventListener('click', attempt(async () => {
    const {toml} = await ask('/save', {values: state.values});
    const link = Object.assign(document.createElement('a'), {download: 'case.toml', href: URL.createObjectURL(new Blob([toml]))});
    link.click();
    URL.revokeObjectURL(link.href);
  }));
  find('report').addEventListener('click', attempt(async () => {
    tell('The report is being written.');
    const {folder} = await ask('/report', {values: state.values});
    tell(`The report is in ${folder}.`);
  }));
  find('more').addEventListener('click', attempt(async () => {
    const answer = await ask('/answer', {values: state.values, figures: 'all'});
    find('figures').replaceChildren(...answer.figures.slice(1).map(figure => sectionOf({figures: [figure], handles: []}, '', false)));
    find('more').hidden = true;
  }));
  new ResizeObserver(() => {
    if (!state.answer || Math.abs(find('sections').clientWidth - state.width) < 8) return;
    state.width = find('sections').clientWidth;
    show(state.answer);
    refreshMap();
  }).observe(find('sections'));
  document.addEventListener('keydown', event => {
    if (!event.ctrlKey || /^(number|text)$/.test(event.target.type)) return;  // there the browser undoes typing
    if (event.key === 'z' && !event.shiftKey) { event.preventDefault(); step(state.past, state.future); }
    if (event.key === 'y' || (event.key === 'z' && event.shiftKey) || event.key === 'Z') { event.preventDefault(); step(state.future, state.past); }
  });
}

async function begin() {
  state.open = await ask('/open');
  document.title = state.open.title;
  find('title').textContent = state.open.title;
  find('about').textContent = state.open.description;
  buildInputs(state.open.groups);
  addTools();
  addStudy();
  addMap();
  find('design').hidden = !state.open.designs_support;
  const said = state.open.designs_support && await designSupport().catch(error => error.message);
  state.start = {...state.values};
  showInputs();
  if (state.open.moves) await beginMotion();
  else await refresh();
  if (said) tell(said);
  document.body.dataset.ready = 'yes';
}

attempt(begin)();
