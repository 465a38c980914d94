import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { useStudio } from './page-modules.js';

useStudio();
const { isShared, sharedHash, sharedProgram } = await import('../../main/page/page/share.js');
const { filled } = await import('../../main/page/page/project.js');

const hashOf = (bytes) => `#program?shared=${deflateRawSync(bytes).toString('base64url')}`;

test('a link restores any program', async () => {
  const text = 'class A {} // grüße 🤖\r\n\tline\n'.repeat(3000);

  const hash = `#${await sharedHash('MyAgent.java', text)}`;

  assert.equal(isShared(hash), true);
  assert.deepEqual(await sharedProgram(hash), { path: 'MyAgent.java', text });
});

test('a link of the first format is read', async () => {
  assert.deepEqual(await sharedProgram(hashOf('MyAgent.java\nclass A {}')), {
    path: 'MyAgent.java',
    text: 'class A {}',
  });
});

test('a link that is incomplete or damaged is refused in one sentence', async () => {
  const whole = hashOf(`MyAgent.java\n${Array.from({ length: 400 }, (_, i) => `line ${i * 7919}`).join('\n')}`);
  const damaged = [
    '#program?shared=',
    '#program?shared=%',
    '#program?shared=!!!!',
    whole.slice(0, whole.length / 2),
    whole.slice(0, -3),
    hashOf('only a name'),
    hashOf(Uint8Array.of(65, 10, 0xff, 0xfe)),
  ];
  for (const hash of damaged) {
    await assert.rejects(sharedProgram(hash), {
      message: /^The program in this link cannot be read: .* Ask for the complete link/,
    });
  }
});

test('a link that unpacks to an oversized program is refused before it is unpacked completely', async () => {
  await assert.rejects(sharedProgram(hashOf(Buffer.alloc(300_000_000))), { message: /larger than 1 MB/ });
});

test('two programs with the same class are both exported', () => {
  const template = {
    name: 'my-robot',
    package: 'myrobot',
    texts: { robonewbie: '', 'robonewbie.cmd': '' },
    libraries: [],
  };
  const programs = new Map([
    ['MyAgent.java', 'public class MyAgent { int a; }'],
    ['MyAgent2.java', 'public class MyAgent { int b; }'],
    ['myagent.java', 'public class myagent { int c; }'],
  ]);

  const texts = filled(template, programs, 'MyAgent2.java');

  assert.match(texts.get('src/main/java/myrobot/MyAgent.java'), /^package myrobot;[^]*int a/);
  assert.match(texts.get('src/main/java/myrobot/myagent2/MyAgent.java'), /^package myrobot\.myagent2;[^]*int b/);
  const names = [...texts.keys()].map((path) => path.toLowerCase());
  assert.equal(new Set(names).size, names.length);
  assert.equal([...texts.values()].filter((text) => text.includes('int c')).length, 1);
});

test('no path of the project leaves it', () => {
  const template = {
    name: 'my-robot',
    package: 'myrobot',
    texts: { robonewbie: '', 'robonewbie.cmd': '' },
    libraries: [],
  };

  const texts = filled(
    template,
    new Map([
      ['..\\..\\evil.java', 'class A {}'],
      ['../../.bashrc', ''],
    ]),
    '',
  );

  assert.deepEqual(
    [...texts.keys()].filter((path) => /\.\.|\\/.test(path)),
    [],
  );
});
