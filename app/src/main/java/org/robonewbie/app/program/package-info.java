/** Finds, compiles and starts the programs that students write. Read {@link org.robonewbie.app.program.AgentFinder} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.program;
