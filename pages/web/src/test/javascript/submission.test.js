import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { useStudio } from './page-modules.js';

useStudio();
const { readFile, readLinks, submissionFile, submissionLink } = await import('../../main/page/page/submission.js');
const { withReferences } = await import('../../main/page/page/project.js');

const PAGE = 'https://robots.example/2026/';
const text = JSON.stringify({ version: 1, student: 'Zoë', files: { 'Kick.java': 'class Kick {} // grüße' } });
const linkOf = async (content) => submissionLink(await submissionFile(content), PAGE);

test('a link and a file contain the same submission', async () => {
  const bytes = await submissionFile(text);
  const link = submissionLink(bytes, `${PAGE}#field/exercises`);

  assert.match(link, /^https:\/\/robots\.example\/2026\/class\.html#submission=[\w-]+$/);
  assert.deepEqual(await readLinks(link, 'pasted'), [{ source: 'pasted', text }]);
  assert.deepEqual(await readFile(new File([bytes], 'Zoë.robonewbie')), [{ source: 'Zoë.robonewbie', text }]);
});

test('a submission that is too long for mail programs has no link', async () => {
  assert.equal(await linkOf(Array.from({ length: 900 }, (_, i) => i * 7919).join()), '');
});

test('each link of a text is read, and a damaged one is named with its line', async () => {
  const link = await linkOf(text);

  const found = await readFile(new File([`Hello,\r\n\r\n<${link}>\n${link.slice(0, -30)}\n`], 'links.txt'));

  assert.deepEqual(found, [
    { source: 'links.txt, line 3', text },
    { source: 'links.txt, line 4', trouble: 'It is incomplete or damaged. Ask for it again.' },
  ]);
});

test('other files are named', async () => {
  const bomb = gzipSync(Buffer.alloc(20_000_000));

  assert.deepEqual(await readFile(new File(['no link'], 'notes.txt')), [
    { source: 'notes.txt', trouble: 'It contains no submission.' },
  ]);
  assert.deepEqual(await readFile(new File([bomb], 'bomb.robonewbie')), [
    { source: 'bomb.robonewbie', trouble: 'It is larger than 1 MB unpacked.' },
  ]);
});

test('a program comes with the classes that it uses', () => {
  const files = new Map([
    ['Kick.java', 'public class Kick { Walker walker; }'],
    ['KickOff.java', 'public class KickOff {}'],
    ['My Walker.java', 'public class Walker { Step step; }'],
    ['Step.java', 'record Step(Kick kick) {}'],
  ]);

  assert.deepEqual([...withReferences(files, 'Kick.java').keys()], ['Kick.java', 'My Walker.java', 'Step.java']);
});
