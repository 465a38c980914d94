/**
 * Distributed execution of batches on Apache Spark. Read {@link org.robonewbie.cluster.SparkRunner} first, then
 * docs/cluster.md.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.cluster;
