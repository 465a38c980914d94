/**
 * What is kept of a contest: finished trials, the table as page, CSV and JSON, certificates. Start reading with {@link org.robonewbie.competition.result.ResultFolder}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.result;
