/**
 * The commands that an agent sends to the simulator in each cycle. Read {@link
 * org.robonewbie.protocol.effector.EffectorCommand} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.effector;
