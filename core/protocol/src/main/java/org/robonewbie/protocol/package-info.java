/**
 * The wire protocol of SimSpark: the messages between agents and simulator. Read {@code perceptor} and {@code effector} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol;
