/** Tests of the server, over real connections. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.server;
