import assert from 'node:assert/strict';
import { test } from 'node:test';

const { insteadOfMissing, missingClasses } = await import('../../../../web/src/main/page/page/missing-classes.js');

const MISSING = missingClasses(`java.awt Graphics
java.io File BufferedReader
java.lang Thread ThreadLocal
java.math BigDecimal
java.time Instant
java.util Date EnumMap Scanner Timer TimerTask Vector WeakHashMap UUID
java.util.concurrent CompletableFuture Executors TimeUnit
java.util.concurrent.atomic AtomicInteger
javax.swing JFrame
`);

/** @param {string} kind @param {string} name @param {string} [location] */
const unknown = (kind, name, location = 'class MyAgent') =>
  `cannot find symbol\n  symbol:   ${kind} ${name}\n  location: ${location}`;

/** @param {string} remark */
const said = (remark) => insteadOfMissing(remark, MISSING);

test('a static call of a missing class is recognised like its type', () => {
  for (const kind of ['variable', 'class']) {
    assert.match(said(unknown(kind, 'Thread')), /^This page has no threads: .* nao\.getTime\(\) instead of waiting\./);
    assert.match(said(unknown(kind, 'TimeUnit')), /instead of waiting/);
    assert.match(said(unknown(kind, 'Executors')), /^This page has no threads: let think\(\) do a little/);
    assert.match(said(unknown(kind, 'AtomicInteger')), /no threads/);
    assert.match(said(unknown(kind, 'Scanner')), /cannot use files or the keyboard/);
    assert.match(said(unknown(kind, 'Instant')), /nao\.getTime\(\)/);
    assert.match(said(unknown(kind, 'JFrame')), /cannot open windows/);
  }
});

test('each other missing Java class is reported with an alternative', () => {
  assert.equal(
    said(unknown('class', 'EnumMap')),
    'This page does not provide java.util.EnumMap: use HashMap or TreeMap instead. RoboNewbie on your computer supports this.',
  );
  assert.equal(
    said(unknown('variable', 'UUID')),
    'This page does not provide java.util.UUID. RoboNewbie on your computer supports this.',
  );
});

test('imports are recognised by their package', () => {
  assert.match(said(unknown('class', 'Executors', 'package java.util.concurrent')), /no threads/);
  assert.match(said(unknown('class', 'EnumMap', 'package java.util')), /HashMap or TreeMap/);
  assert.match(said('package java.util.concurrent.atomic does not exist'), /no threads/);
  assert.match(said('package javax.swing does not exist'), /cannot open windows/);
  assert.match(said('This page does not provide java.lang.Thread.sleep'), /no threads/);
});

test('a qualified name is recognised whatever the compiler knows of its package', () => {
  const saidOf = (/** @type {string} */ remark, /** @type {string} */ code) => insteadOfMissing(remark, MISSING, code);
  assert.match(saidOf('package java.math does not exist', 'java.math.BigDecimal'), /BigDecimal: use double instead/);
  assert.match(
    saidOf('package java.util.concurrent.TimeUnit does not exist', 'java.util.concurrent.TimeUnit.SECONDS'),
    /no threads/,
  );
  assert.match(saidOf('package java.time does not exist', 'java.time.Instant'), /nao\.getTime\(\)/);
  assert.equal(saidOf(unknown('class', 'Dates', 'package java.util'), 'java.util.Dates'), '');
});

test('misspelt names and missing imports are left to the compiler', () => {
  assert.equal(said(unknown('class', 'EnumMapp')), '');
  assert.equal(said(unknown('class', 'List')), '');
  assert.equal(said(unknown('variable', 'thread')), '');
  assert.equal(said(unknown('class', 'Lisst', 'package java.util')), '');
  assert.equal(said('package java.utl does not exist'), '');
  assert.equal(said('package org.robonewbie.agnet does not exist'), '');
});

test('programs cannot start trials in the page', () => {
  assert.match(said(unknown('class', 'Grader')), /press Check/);
});
