/** The API for robot programs. Read {@code Agent} and {@code Nao} first; a newcomer needs no other class. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent;
