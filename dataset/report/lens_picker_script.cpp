#include "dataset/report/lens_picker_script.h"

namespace cps {

const char* const lens_picker_script = R"js(
'use strict';
(() => {
  const find = id => document.getElementById(id);
  const lenses = JSON.parse(find('lens-data').textContent);
  const list = find('lens'), drawing = find('lens-drawing'), numbers = find('lens-numbers'), straight = find('lens-straight');
  const cells = 16, samples = 96;  // of the grid across the base's width; of each of its lines

  // Brown-Conrady, from ideal to distorted on the plane z = 1, then to pixels.
  const distort = (l, x, y) => {
    const s = x * x + y * y, radial = 1 + s * (l.k1 + s * (l.k2 + s * l.k3));
    return [x * radial + 2 * l.p1 * x * y + l.p2 * (s + 2 * x * x),
            y * radial + l.p1 * (s + 2 * y * y) + 2 * l.p2 * x * y];
  };
  const pixel = (l, [x, y]) => [l.fx * x + l.cx, l.fy * y + l.cy];

  const line = (l, map, from, to) => {
    let path = '';
    for (let i = 0; i <= samples; ++i) {
      const t = i / samples;
      const [u, v] = pixel(l, map(l, from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])));
      path += (i ? 'L' : 'M') + u.toFixed(2) + ' ' + v.toFixed(2);
    }
    return path;
  };

  // The lines of a square grid inside the base's frame, where the lens is certified, and the frame's rim.
  const grid = (l, map) => {
    const X = Math.tan(l.fov_base_deg * Math.PI / 360), Y = X * l.height / l.width, step = 2 * X / cells;
    let path = '';
    for (let i = -cells / 2 + 1; i < cells / 2; ++i) path += line(l, map, [i * step, -Y], [i * step, Y]);
    for (let j = -Math.ceil(Y / step) + 1; j * step < Y; ++j) path += line(l, map, [-X, j * step], [X, j * step]);
    return path;
  };
  const rim = l => {
    const X = Math.tan(l.fov_base_deg * Math.PI / 360), Y = X * l.height / l.width;
    return line(l, distort, [-X, -Y], [X, -Y]) + line(l, distort, [X, -Y], [X, Y]) +
           line(l, distort, [X, Y], [-X, Y]) + line(l, distort, [-X, Y], [-X, -Y]);
  };

  const add = (name, kind, attributes) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    element.setAttribute('class', kind);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    drawing.append(element);
  };

  const draw = l => {
    const margin = 0.08 * l.width;
    drawing.replaceChildren();
    drawing.setAttribute('viewBox', [-0.5 - margin, -0.5 - margin, l.width + 2 * margin, l.height + 2 * margin].join(' '));
    drawing.setAttribute('aria-label', 'A straight grid through ' + l.folder);
    add('rect', 'image', {x: -0.5, y: -0.5, width: l.width, height: l.height});
    if (straight.checked) add('path', 'straight', {d: grid(l, (_, x, y) => [x, y])});
    add('path', 'grid', {d: grid(l, distort)});
    add('path', 'rim', {d: rim(l)});
    add('rect', 'edge', {x: -0.5, y: -0.5, width: l.width, height: l.height});
    add('circle', 'centre', {cx: l.cx, cy: l.cy, r: 0.008 * l.width});
  };

  const tell = l => {
    const rows = [['group', l.folder], ['part', l.part], ['images', l.images], ['camera', l.camera],
      ['size, px', l.width + ' × ' + l.height], ['H-FOV, degrees', l.fov], ['H-FOV before the crop', l.fov_base_deg],
      ['really shown: h, v, d', l.fov_true_deg.map(a => a.toFixed(4)).join(', ')],
      ['fx, px', l.fx], ['fy, px', l.fy]];
    for (const key of ['k1', 'k2', 'k3', 'p1', 'p2', 'cx', 'cy'])
      rows.push([key, l[key], l.limits[key] ? 'drawn from ' + l.limits[key].map(x => Number(x.toPrecision(6))).join(' … ') : '']);
    rows.push(['zoom of the crop', l.zoom], ['smallest local scale', l.min_eigenvalue],
      ['worst round trip, px', l.max_roundtrip_px]);
    numbers.replaceChildren(...rows.map(cells => {
      const row = document.createElement('tr');
      row.insertCell().textContent = cells[0];
      const value = row.insertCell();
      value.textContent = cells[1];
      if (cells[2]) value.append(document.createElement('br'), cells[2]);
      return row;
    }));
  };

  const show = () => {
    const l = lenses[Number(list.value)];
    if (!l) return;
    draw(l);
    tell(l);
  };
  const step = by => {
    list.selectedIndex = (list.selectedIndex + by + list.options.length) % list.options.length;
    show();
  };
  const fromFragment = () => {
    const i = lenses.findIndex(l => ['#lens=' + l.folder, '#lens=' + encodeURI(l.folder)].includes(location.hash));
    if (i < 0) return;
    list.value = i;
    show();
    find('lenses').scrollIntoView();
  };
  list.addEventListener('change', show);
  straight.addEventListener('change', show);
  find('lens-previous').addEventListener('click', () => step(-1));
  find('lens-next').addEventListener('click', () => step(1));
  addEventListener('hashchange', fromFragment);
  show();
  fromFragment();
})();
)js";

}  // namespace cps
