/** Programs of teams that behave as badly as programs can. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.programs;
