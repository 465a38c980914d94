/**
 * Replacements for {@code java.time} where TeaVM's class library has gaps.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.java.time;
