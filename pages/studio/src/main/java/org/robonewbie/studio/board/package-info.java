/**
 * Progress pages of running programs. Start with {@link org.robonewbie.studio.board.EventBus}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.board;
