// Figures as the program describes them, drawn as SVG.
const svgNamespace = 'http://www.w3.org/2000/svg';

function svg(name, attributes, parent) {
  const element = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes || {})) element.setAttribute(key, value);
  if (parent) parent.append(element);
  return element;
}

function pointsOf(series) {
  switch (series.kind) {
  case 'boxes': return series.boxes.flat();
  case 'arrows': return series.shafts.flat();
  case 'heat_map': return [[series.x[0], series.y[0]], [series.x.at(-1), series.y.at(-1)]];
  default: return series.points;
  }
}

function extentOf(figure, index, axis) {
  if (axis.range) return axis.range;
  let low = Infinity, high = -Infinity;
  for (const series of figure.series)
    for (const point of pointsOf(series))
      if (point[index] !== null) { low = Math.min(low, point[index]); high = Math.max(high, point[index]); }
  if (!(low <= high)) return [0, 1];
  const pad = (high - low || Math.abs(high) || 1) * .05;
  return [low - pad, high + pad];
}

function ticksOf([low, high], most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(one => one * power).find(one => one >= rough);
  const ticks = [];
  for (let at = Math.ceil(low / step) * step; at <= high + step * 1e-9; at += step)
    ticks.push([at, String(Number(at.toPrecision(10)))]);
  return ticks;
}

const dashes = {solid: 'none', dashed: '9 6', dotted: '2 4'};
const titleOf = axis => axis.title + (axis.unit ? ` (${axis.unit})` : '');

// Draws a figure that will be shown this many pixels wide; `toData` and `toPicture` convert positions for dragging.
function drawFigure(figure, shown) {
  const width = Math.min(720, Math.max(300, shown)), left = figure.frame ? 64 : 8, right = 12, top = 10, bottom = figure.frame ? 48 : 8;
  let xs = extentOf(figure, 0, figure.x), ys = extentOf(figure, 1, figure.y);
  const across = width - left - right;
  let upwards = Math.round(across * figure.height / figure.width);
  if (figure.equal_scales) {
    upwards = Math.min(560, Math.max(200, across * (ys[1] - ys[0]) / (xs[1] - xs[0])));
    const metre = Math.max((xs[1] - xs[0]) / across, (ys[1] - ys[0]) / upwards);
    const wider = (across * metre - (xs[1] - xs[0])) / 2, higher = (upwards * metre - (ys[1] - ys[0])) / 2;
    xs = [xs[0] - wider, xs[1] + wider];
    ys = [ys[0] - higher, ys[1] + higher];
  }
  const height = top + upwards + bottom;
  const toX = x => left + (x - xs[0]) / (xs[1] - xs[0]) * across;
  const toY = y => top + (ys[1] - y) / (ys[1] - ys[0]) * upwards;
  const picture = svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'group', 'aria-label': figure.title});
  picture.ranges = [xs, ys];
  picture.toPicture = ([x, y]) => [toX(x), toY(y)];
  picture.toData = (x, y) => [xs[0] + (x - left) / across * (xs[1] - xs[0]), ys[1] - (y - top) / upwards * (ys[1] - ys[0])];
  const clip = 'clip' + Math.random().toString(36).slice(2);
  svg('rect', {x: left, y: top, width: across, height: upwards}, svg('clipPath', {id: clip}, svg('defs', {}, picture)));
  if (figure.frame) {
    for (const [at, text] of figure.x.ticks || ticksOf(xs, Math.max(3, Math.round(width / 90)))) {
      if (figure.x.grid) svg('line', {class: 'grid', x1: toX(at), x2: toX(at), y1: top, y2: top + upwards}, picture);
      svg('text', {x: toX(at), y: top + upwards + 17, 'text-anchor': 'middle'}, picture).textContent = text;
    }
    for (const [at, text] of figure.y.ticks || ticksOf(ys, 6)) {
      if (figure.y.grid) svg('line', {class: 'grid', x1: left, x2: left + across, y1: toY(at), y2: toY(at)}, picture);
      svg('text', {x: left - 6, y: toY(at) + 4, 'text-anchor': 'end'}, picture).textContent = text;
    }
    svg('text', {x: left + across / 2, y: height - 8, 'text-anchor': 'middle'}, picture).textContent = titleOf(figure.x);
    svg('text', {x: 14, y: top + upwards / 2, transform: `rotate(-90 14 ${top + upwards / 2})`, 'text-anchor': 'middle'}, picture)
      .textContent = titleOf(figure.y);
  }
  const inside = svg('g', {'clip-path': `url(#${clip})`}, picture);
  const paint = name => `var(--${name})`;
  const path = (points, closed) => {
    let text = '', pen = 'M';
    for (const [x, y] of points) {
      if (x === null || y === null) { pen = 'M'; continue; }
      text += `${pen}${toX(x).toFixed(2)},${toY(y).toFixed(2)}`;
      pen = 'L';
    }
    return text + (closed && text ? 'Z' : '');
  };
  const arrow = (from, to, colour, wide, both) => {
    svg('path', {d: path([from, to]), fill: 'none', stroke: colour, 'stroke-width': wide}, inside);
    const head = (at, back) => {
      const [x, y] = [toX(at[0]), toY(at[1])], angle = Math.atan2(y - toY(back[1]), x - toX(back[0]));
      const corner = turn => `${x - 9 * Math.cos(angle + turn)},${y - 9 * Math.sin(angle + turn)}`;
      svg('path', {d: `M${corner(.45)}L${x},${y}L${corner(-.45)}`, fill: 'none', stroke: colour, 'stroke-width': wide}, inside);
    };
    head(to, from);
    if (both) head(from, to);
  };
  const described = (element, series) => {
    if (series.legend) svg('title', {}, element).textContent = series.legend;
    return element;
  };
  for (const series of figure.series) {
    const colour = paint(series.colour);
    if (series.kind === 'line')
      described(svg('path', {d: path(series.points), fill: 'none', stroke: colour, 'stroke-width': series.width,
        'stroke-dasharray': dashes[series.dash]}, inside), series);
    else if (series.kind === 'region')
      described(svg('path', {d: path(series.points, true), fill: colour, 'fill-opacity': series.opacity}, inside), series);
    else if (series.kind === 'points')
      for (const [x, y] of series.points) {
        if (x === null || y === null) continue;
        const hollow = series.marker === 'circle';
        described(svg('circle', {cx: toX(x), cy: toY(y), r: 4 * series.size, fill: hollow ? 'none' : colour, stroke: colour}, inside), series);
      }
    else if (series.kind === 'boxes')
      for (const [low, high] of series.boxes)
        described(svg('rect', {x: toX(low[0]), y: toY(high[1]), width: Math.max(0, toX(high[0]) - toX(low[0])),
          height: Math.max(0, toY(low[1]) - toY(high[1])), fill: colour}, inside), series);
    else if (series.kind === 'arrows')
      for (const [from, to] of series.shafts) arrow(from, to, colour, series.width, false);
    else if (series.kind === 'heat_map') {
      const dx = series.x[1] - series.x[0], dy = series.y[1] - series.y[0];
      series.values.forEach((row, j) => row.forEach((value, i) => svg('rect', {x: toX(series.x[i] - dx / 2), y: toY(series.y[j] + dy / 2),
        width: toX(dx) - toX(0) + .5, height: toY(0) - toY(dy) + .5,
        fill: value === null ? 'var(--grey)' : `hsl(205 60% ${90 - 60 * Math.min(1, value / series.ceiling)}%)`}, inside)));
    }
  }
  for (const one of figure.arrows) arrow(one.from, one.to, paint(one.colour), 2, one.both_heads);
  for (const label of figure.labels) {
    if (label.at[0] === null || label.at[1] === null) continue;
    svg('text', {x: toX(label.at[0]), y: toY(label.at[1]) + 4 - 13 * label.raise, class: label.boxed ? 'box' : '',
      'text-anchor': {left: 'start', centre: 'middle', right: 'end'}[label.align], style: `fill: ${paint(label.colour)}`}, picture)
      .textContent = label.text;
  }
  return picture;
}

// Moves down boxed names that would overlap others; the picture must be visible.
function spreadLabels(picture) {
  const placed = [];
  for (const label of picture.querySelectorAll('text.box')) {
    const meets = box => placed.some(one => box.x < one.x + one.width && one.x < box.x + box.width && box.y < one.y + one.height && one.y < box.y + box.height);
    let box = label.getBBox();
    for (let turn = 0; turn < 4 && meets(box); ++turn) {
      label.setAttribute('y', Number(label.getAttribute('y')) + box.height);
      box = label.getBBox();
    }
    placed.push(box);
  }
}

// Explains colours and dashes, in words that follow each other below the picture.
function legendOf(figure) {
  const list = Object.assign(document.createElement('ul'), {className: 'legend'});
  const shown = new Set();
  for (const series of figure.series) {
    if (!series.legend || shown.has(series.legend)) continue;
    shown.add(series.legend);
    const entry = document.createElement('li');
    const sample = svg('svg', {viewBox: '0 0 28 12', 'aria-hidden': 'true'}, entry), colour = `var(--${series.colour})`;
    const line = width => svg('path', {d: 'M1,6H27', stroke: colour, 'stroke-width': width, 'stroke-dasharray': dashes[series.dash] || 'none'}, sample);
    if (series.kind === 'line') line(series.width);
    else if (series.kind === 'arrows') { line(series.width); svg('path', {d: 'M19,1L27,6L19,11', fill: 'none', stroke: colour, 'stroke-width': series.width}, sample); }
    else if (series.kind === 'points') svg('circle', {cx: 14, cy: 6, r: Math.min(5, 4 * series.size), fill: series.marker === 'circle' ? 'none' : colour, stroke: colour}, sample);
    else svg('rect', {x: 1, y: 0, width: 26, height: 12, fill: colour, 'fill-opacity': series.opacity ?? 1}, sample);
    entry.append(series.legend);
    list.append(entry);
  }
  return list;
}

// Draws a factor of safety over two inputs: light where the slope stands, dark where it fails, with the line of 1 and
// the valley of the misfit, if there is one.
function drawMap(map, titles, here, shown, misfit) {
  const figure = {title: 'factor of safety', x: titles[0], y: titles[1], equal_scales: false, frame: true, width: 640, height: 480,
    series: [], labels: [], arrows: []};
  figure.x.range = [map.x[0], map.x.at(-1)];
  figure.y.range = [map.y[0], map.y.at(-1)];
  const dx = map.x[1] - map.x[0], dy = map.y[1] - map.y[0];
  const shades = new Map();
  map.values.forEach((row, j) => row.forEach((value, i) => {
    const shade = value === null ? 'none' : Math.max(0, Math.min(10, Math.round(value * 5)));
    if (!shades.has(shade)) shades.set(shade, []);
    shades.get(shade).push([map.x[i] - dx / 2, map.y[j] - dy / 2]);
  }));
  const picture = drawFigure(figure, shown);
  const inside = svg('g', {}, picture), [x0, y0] = picture.toPicture([0, 0]), [x1, y1] = picture.toPicture([dx, dy]);
  for (const [shade, cells] of shades) {
    const d = cells.map(cell => { const [x, y] = picture.toPicture(cell); return `M${x.toFixed(1)},${y.toFixed(1)}h${(x1 - x0 + .4).toFixed(2)}v${(y1 - y0 - .4).toFixed(2)}h${(x0 - x1 - .4).toFixed(2)}Z`; }).join('');
    svg('path', {d, fill: shade === 'none' ? 'var(--grey)' : shade < 5 ? `hsl(22 90% ${45 + 8 * shade}%)` : `hsl(205 60% ${100 - 4 * shade}%)`}, inside);
  }
  const contour = (values, level, title, stroke, dash) => {
    const line = contourOf(values, level).map(([from, to]) => {
      const [a, b] = picture.toPicture(from), [c, d] = picture.toPicture(to);
      return `M${a.toFixed(1)},${b.toFixed(1)}L${c.toFixed(1)},${d.toFixed(1)}`;
    }).join('');
    svg('title', {}, svg('path', {d: line, fill: 'none', stroke, 'stroke-width': 2, 'stroke-dasharray': dash}, picture)).textContent = title;
  };
  contour(map, 1, 'factor of safety 1', 'var(--ink)', 'none');
  if (misfit) {
    // Chi-square with two degrees of freedom.
    const least = Math.min(...misfit.values.flat().filter(value => value !== null));
    contour(misfit, least + 2.30, 'valley of the misfit: 68 %', 'var(--green)', 'none');
    contour(misfit, least + 5.99, 'valley of the misfit: 95 %', 'var(--green)', '7 5');
  }
  const [x, y] = picture.toPicture(here);
  svg('circle', {class: 'here', cx: x, cy: y, r: 7}, picture);
  return picture;
}

// Returns the segments of the line on which the values are `level`, by marching through the cells.
function contourOf(map, level) {
  const segments = [];
  for (let j = 0; j + 1 < map.y.length; ++j)
    for (let i = 0; i + 1 < map.x.length; ++i) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const values = corners.map(([a, b]) => map.values[b][a]);
      if (values.includes(null)) continue;
      const cuts = [];
      for (let side = 0; side < 4; ++side) {
        const next = (side + 1) % 4, low = values[side], high = values[next];
        if ((low < level) === (high < level)) continue;
        const share = (level - low) / (high - low);
        const at = (axis, index) => axis[corners[side][index]] + share * (axis[corners[next][index]] - axis[corners[side][index]]);
        cuts.push([at(map.x, 0), at(map.y, 1)]);
      }
      for (let cut = 0; cut + 1 < cuts.length; cut += 2) segments.push([cuts[cut], cuts[cut + 1]]);
    }
  return segments;
}
