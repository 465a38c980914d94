/**
 * Example agents for the lessons. Read {@link org.robonewbie.examples.Agent_Wave} first, then {@link
 * org.robonewbie.examples.Agent_BasicStructure} and {@link org.robonewbie.examples.Agent_SimpleSoccer}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.examples;
