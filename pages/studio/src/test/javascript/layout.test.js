import assert from 'node:assert/strict';
import test from 'node:test';
import {
  defaultLayout,
  PANEL_TITLES,
  panelsOf,
  placed,
  restoredLayout,
  shows,
  toggled,
  widthOf,
  withEdgeMoved,
} from '../../main/resources/org/robonewbie/studio/web/state/layout.js';

const ROOMS = /** @type {const} */ (['field', 'program', 'robot', 'replay']);
const wide = defaultLayout('robot', 'wide');

for (const room of ROOMS) {
  for (const [width, height] of [
    [1440, 800],
    [1024, 680],
    [700, 900],
  ]) {
    test(`the panels of room ${room} fit side by side in a window of ${width} pixels`, () => {
      const everything = everyPanelOf(defaultLayout(room, widthOf(width)));

      const { boxes } = placed(everything, width, height);

      const all = [...boxes.values()];
      assert.deepEqual([...boxes.keys()].sort(), panelsOf(everything).sort());
      all.forEach((box, i) => {
        assert.ok(box.left >= 0 && box.top >= 0 && box.height > 60);
        assert.ok(box.left + box.width <= width + 0.01 && box.top + box.height <= height + 0.01);
        all.slice(i + 1).forEach((other) => assert.ok(!overlap(box, other)));
      });
    });
  }
}

test('each panel belongs to one of the rooms', () => {
  const all = ROOMS.flatMap((room) => panelsOf(defaultLayout(room, 'wide')));

  assert.deepEqual([...new Set(all)].sort(), Object.keys(PANEL_TITLES).sort());
});

test('the field and the replay begin with the picture alone, which fills the room', () => {
  for (const room of /** @type {const} */ (['field', 'replay'])) {
    const { boxes, edges } = placed(defaultLayout(room, 'wide'), 1400, 800);

    assert.deepEqual([...boxes], [['picture', { left: 0, top: 0, width: 1400, height: 800 }]]);
    assert.deepEqual(edges, []);
  }
});

function everyPanelOf(layout) {
  return layout.map((column) => ({
    ...column,
    panels: column.panels.map((panel) => ({ ...panel, isHidden: false })),
  }));
}

function overlap(a, b) {
  const across = a.left < b.left + b.width - 0.01 && b.left < a.left + a.width - 0.01;
  return across && a.top < b.top + b.height - 0.01 && b.top < a.top + a.height - 0.01;
}

test('an edge between columns keeps the sum of their widths', () => {
  const moved = withEdgeMoved(wide, { column: 0, panel: undefined }, 0.1);

  assert.deepEqual(
    moved.map(({ part }) => part.toFixed(2)),
    ['0.55', '0.20', '0.25'],
  );
});

test('no panel becomes too small to be visible', () => {
  const moved = withEdgeMoved(wide, { column: 0, panel: 0 }, 9);

  const { boxes } = placed(moved, 1400, 800);
  assert.ok((boxes.get('words')?.height ?? 0) > 80);
});

test('a hidden panel leaves its space to the others of its column', () => {
  const layout = toggled(wide, 'surroundings');

  const { boxes, edges } = placed(layout, 1400, 700);

  assert.ok(!shows(layout, 'surroundings') && !boxes.has('surroundings'));
  assert.equal(boxes.get('curves')?.height, 700);
  assert.ok(!edges.some(({ column, panel }) => column === 1 && panel !== undefined));
  assert.deepEqual(toggled(layout, 'surroundings'), wide);
});

test('a column without a shown panel leaves its space to the other columns', () => {
  const layout = toggled(toggled(wide, 'curves'), 'surroundings');

  const { boxes, edges } = placed(layout, 1400, 700);
  const moved = placed(withEdgeMoved(layout, { column: 0, panel: undefined }, 0.1), 1400, 700).boxes;

  assert.ok((boxes.get('picture')?.width ?? 0) > 800);
  assert.equal(edges.filter(({ panel }) => panel === undefined).length, 1);
  assert.ok(Math.abs((moved.get('picture')?.width ?? 0) - (boxes.get('picture')?.width ?? 0) - 140) < 2);
});

test('a stored layout is restored unless it is damaged, of another room or of another version', () => {
  const kept = JSON.parse(JSON.stringify(withEdgeMoved(wide, { column: 1, panel: undefined }, 0.05)));
  assert.deepEqual(restoredLayout(kept, 'robot', 'wide'), kept);

  for (const damaged of [
    undefined,
    7,
    [],
    [{ part: 1 }],
    kept.slice(1),
    [{ ...kept[0], part: -1 }, ...kept.slice(1)],
    defaultLayout('program', 'wide'),
  ]) {
    assert.deepEqual(restoredLayout(damaged, 'robot', 'wide'), wide);
  }
});
