@org.jspecify.annotations.NullMarked
package org.robonewbie.bench.speed;
