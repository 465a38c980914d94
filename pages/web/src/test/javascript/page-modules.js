/** Resolves the page's imports of studio scripts, which share a folder only after the build. */
import { existsSync } from 'node:fs';
import { register } from 'node:module';

const STUDIO = new URL('../../../../studio/src/main/resources/org/robonewbie/studio/web/', import.meta.url);
const PAGE = new URL('../../main/page/', import.meta.url);

/** @type {import('node:module').ResolveHook} */
export async function resolve(specifier, context, next) {
  const url = specifier.startsWith('.') ? new URL(specifier, context.parentURL).href : specifier;
  const isOfStudio = url.startsWith(PAGE.href) && !existsSync(new URL(url));
  return next(isOfStudio ? new URL(url.slice(PAGE.href.length), STUDIO).href : specifier, context);
}

export const useStudio = () => register(import.meta.url);
