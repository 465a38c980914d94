/**
 * Text as people save it, whatever program they use: {@link org.robonewbie.nao.text.DecodedText}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.text;
