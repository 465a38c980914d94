/**
 * S-expressions, the syntax of all SimSpark messages: nested lists of words in parentheses. Read {@link
 * org.robonewbie.protocol.sexp.SexpReader} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.sexp;
