/**
 * RoboNewbie in a web page: simulator, framework and examples as a WebAssembly module. Start with {@link
 * org.robonewbie.web.WebEdition}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web;
