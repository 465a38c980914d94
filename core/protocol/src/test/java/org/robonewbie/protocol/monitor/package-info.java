/** Tests of the monitor protocol, among them a recording of a real server. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.monitor;
