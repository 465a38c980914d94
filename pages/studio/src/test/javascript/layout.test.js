import assert from 'node:assert/strict';
import test from 'node:test';
import {
  FOLDED_PIXELS,
  LAYOUTS,
  PANEL_TITLES,
  placed,
  restoredLayout,
  toggled,
  UNDERSTAND,
  widthOf,
  withEdgeMoved,
} from '../../main/resources/org/robonewbie/studio/web/state/layout.js';

for (const [preset, layouts] of Object.entries(LAYOUTS)) {
  for (const [width, height] of [
    [1440, 800],
    [1024, 680],
    [700, 900],
  ]) {
    test(`all panels of ${preset} fit side by side in a window of ${width} pixels`, () => {
      const { boxes } = placed(layouts[widthOf(width)], width, height);

      const all = [...boxes.values()];
      assert.deepEqual([...boxes.keys()].sort(), panelsOf(layouts.wide));
      all.forEach((box, i) => {
        assert.ok(box.left >= 0 && box.top >= 0 && box.height >= FOLDED_PIXELS);
        assert.ok(box.left + box.width <= width + 0.01 && box.top + box.height <= height + 0.01);
        all.slice(i + 1).forEach((other) => assert.ok(!overlap(box, other)));
      });
    });
  }
}

test('each panel belongs to one of the presets', () => {
  const all = Object.values(LAYOUTS).flatMap(({ wide }) => panelsOf(wide));

  assert.deepEqual([...new Set(all)].sort(), Object.keys(PANEL_TITLES).sort());
});

function panelsOf(layout) {
  return layout.flatMap(({ panels }) => panels.map(({ name }) => name)).sort();
}

function overlap(a, b) {
  const across = a.left < b.left + b.width - 0.01 && b.left < a.left + a.width - 0.01;
  return across && a.top < b.top + b.height - 0.01 && b.top < a.top + a.height - 0.01;
}

test('an edge between columns keeps the sum of their widths', () => {
  const moved = withEdgeMoved(UNDERSTAND.wide, { column: 0, panel: undefined }, 0.1);

  assert.deepEqual(
    moved.map(({ part }) => part.toFixed(2)),
    ['0.55', '0.20', '0.25'],
  );
});

test('no panel becomes too small to be visible', () => {
  const moved = withEdgeMoved(UNDERSTAND.wide, { column: 0, panel: 0 }, 9);

  const { boxes } = placed(moved, 1400, 800);
  assert.ok((boxes.get('words')?.height ?? 0) > 80);
});

test('a collapsed panel keeps its title, and the others use its space', () => {
  const layout = toggled(UNDERSTAND.medium, 'joints');

  const { boxes, edges } = placed(layout, 1000, 700);
  assert.equal(boxes.get('joints')?.height, FOLDED_PIXELS);
  assert.ok((boxes.get('curves')?.height ?? 0) > 500);
  assert.ok(!edges.some(({ column, panel }) => column === 1 && panel !== undefined));
  assert.deepEqual(toggled(layout, 'joints'), UNDERSTAND.medium);
});

test('an edge below a collapsed panel moves the expanded ones around it', () => {
  const layout = toggled(toggled(UNDERSTAND.medium, 'surroundings'), 'joints');

  const moved = withEdgeMoved(layout, { column: 1, panel: 1 }, 0.2);

  const before = placed(layout, 1000, 700).boxes;
  const after = placed(moved, 1000, 700).boxes;
  assert.ok((after.get('curves')?.height ?? 0) > (before.get('curves')?.height ?? 0) + 50);
  assert.ok((after.get('surroundings')?.height ?? 0) < (before.get('surroundings')?.height ?? 0) - 50);
});

test('a stored layout is restored unless it is damaged or of another version', () => {
  const kept = JSON.parse(JSON.stringify(withEdgeMoved(UNDERSTAND.wide, { column: 1, panel: undefined }, 0.05)));
  assert.deepEqual(restoredLayout(kept, 'wide'), kept);

  for (const damaged of [
    undefined,
    7,
    [],
    [{ part: 1 }],
    kept.slice(1),
    [{ ...kept[0], part: -1 }, ...kept.slice(1)],
  ]) {
    assert.equal(restoredLayout(damaged, 'wide'), UNDERSTAND.wide);
  }
});
