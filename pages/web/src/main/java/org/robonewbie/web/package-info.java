/**
 * RoboNewbie in a page: simulator, framework and examples as a program of WebAssembly. Read {@link
 * org.robonewbie.web.WebEdition} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web;
