/**
 * The wire protocol of SimSpark: the messages between agents and simulator. Start in {@code perceptor} and {@code effector}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol;
