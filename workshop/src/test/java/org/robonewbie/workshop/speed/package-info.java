@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.speed;
