@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.sparse;
