/**
 * Replacements for the package of the same name without the prefix {@code org.robonewbie.web.library}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.org.robonewbie.agent.log;
