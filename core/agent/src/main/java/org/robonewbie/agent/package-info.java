/**
 * What a robot's programmer imports. Read {@code Nao} and {@code Agent} first:
 * these two are all that a newcomer must know.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent;
