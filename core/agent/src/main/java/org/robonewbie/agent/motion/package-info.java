/** Motion control: keyframe motions from text files and the head scan. Read {@link org.robonewbie.agent.motion.Motions} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.motion;
