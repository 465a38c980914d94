import assert from 'node:assert/strict';
import test from 'node:test';
import { boardTriangles } from '../../main/resources/org/robonewbie/studio/web/state/board-shapes.js';

const look = { colour: '#ff0000', text: '' };

test('a line has its coordinates in space', () => {
  const corners = boardTriangles({ ...look, shape: 'line', numbers: [0, 0, 1, 2, 0, 1.5, 1] });

  assert.equal(corners.length, 2 * 2 * 9);
  const heights = corners.filter((_, i) => i % 3 === 2);
  assert.ok(Math.min(...heights) > 0.98 && Math.max(...heights) < 1.52);
});

test('a polygon is filled and raised above the ground', () => {
  const corners = boardTriangles({ ...look, shape: 'polygon', numbers: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] });

  assert.equal(corners.length, 2 * 9);
  assert.ok(corners.filter((_, i) => i % 3 === 2).every((z) => z > 0.005));
});

test('a sphere has its radius, and a polygon with two corners is empty', () => {
  const corners = boardTriangles({ ...look, shape: 'sphere', numbers: [1, 2, 3, 0.5] });
  assert.ok(Math.abs(Math.hypot(corners[0] - 1, corners[1] - 2, corners[2] - 3) - 0.5) < 1e-6);

  assert.deepEqual(boardTriangles({ ...look, shape: 'polygon', numbers: [0, 0, 0, 1, 0, 0] }), []);
});
