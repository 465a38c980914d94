/**
 * What a page of its own reports while a program runs. {@link org.robonewbie.studio.board.EventBus} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.board;
