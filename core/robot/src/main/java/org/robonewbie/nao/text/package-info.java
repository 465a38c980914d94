/**
 * Decoding, checking and formatting of text. Read {@link org.robonewbie.nao.text.DecodedText} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.text;
