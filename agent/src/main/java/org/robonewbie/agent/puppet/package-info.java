/** Robots that people move by hand from the studio; each turns its cycle in a thread of its own. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.puppet;
