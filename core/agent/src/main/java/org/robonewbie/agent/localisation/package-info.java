/**
 * Beyond what is seen right now: how far the robot has moved, where things are after its own movement, and where on the pitch
 * it is. No other class of the framework needs this. Read {@link org.robonewbie.agent.localisation.SelfLocalisation} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.localisation;
