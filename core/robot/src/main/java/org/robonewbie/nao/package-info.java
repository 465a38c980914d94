/** Basic facts about the robot and the pitch. Read {@link org.robonewbie.nao.Joint} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao;
