@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.running;
