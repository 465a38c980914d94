/**
 * The wire protocol of SimSpark: the messages between agents and simulator. Start in {@code perceptor} and {@code effector}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol;
