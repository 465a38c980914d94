package org.robonewbie.cluster;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.jspecify.annotations.Nullable;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.Job;
import scala.Tuple2;
import scala.collection.Iterator;
import scala.reflect.ClassTag$;
import scala.runtime.AbstractFunction1;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/**
 * Runs jobs on the Spark cluster specified by the system property {@code spark.master}. Jobs are distributed in small slices. If a worker
 * fails, its slice is run again; the results of a slice are received as soon as the slice is finished.
 */
public final class SparkRunner implements BatchRunner {

    private static final int JOBS_PER_SLICE = 10;
    private static final int MAX_SLICES = 10_000;

    private @Nullable JavaSparkContext context;

    /** Creates a runner. Spark starts with the first batch and stops with {@link #close}. */
    public SparkRunner() {}

    @Override
    public String label() {
        return "spark";
    }

    @Override
    public <P, R> List<R> run(List<P> parameters, Job<P, R> job, Receiver<? super P, ? super R> results)
            throws IOException {
        if (parameters.isEmpty()) {
            return List.of();
        }
        JavaSparkContext spark = context();
        int slices = Math.max(
                Math.min(parameters.size(), spark.defaultParallelism()),
                Math.min(MAX_SLICES, parameters.size() / JOBS_PER_SLICE));
        List<Tuple2<Integer, P>> numbered = new ArrayList<>(IntStream.range(0, parameters.size())
                .mapToObj(i -> new Tuple2<>(i, parameters.get(i)))
                .toList());
        Results<P, R> all = new Results<>(parameters, results);
        try {
            spark.sc()
                    .runJob(
                            spark.parallelize(numbered, slices).rdd(),
                            new Slice<>(job),
                            all,
                            ClassTag$.MODULE$.apply(List.class));
        } catch (Exception failed) {
            throw unchecked(failed);
        }
        return all.inOrder();
    }

    /**
     * Unwraps an exception thrown by a job or by the receiver. Spark throws checked exceptions without declaring them.
     */
    private static RuntimeException unchecked(Exception failed) throws IOException {
        Throwable cause = failed.getCause();
        if (cause instanceof UncheckedIOException unwritable && unwritable.getCause() != null) {
            throw unwritable.getCause();
        }
        return cause instanceof JobFailedException job
                ? job
                : new IllegalStateException("The Spark job failed: " + failed.getMessage(), failed);
    }

    private JavaSparkContext context() {
        JavaSparkContext spark = context;
        if (spark == null) {
            SparkConf settings = new SparkConf()
                    .setAppName("RoboNewbie")
                    .setIfMissing("spark.task.maxFailures", "8")
                    .setIfMissing("spark.ui.enabled", "false");
            spark = new JavaSparkContext(settings.setIfMissing("spark.master", "local[*]"));
            context = spark;
        }
        return spark;
    }

    @Override
    public void close() {
        JavaSparkContext spark = context;
        if (spark != null) {
            spark.close();
            context = null;
        }
    }

    /** Failure of a job, thrown by the driver so that Spark does not retry the job. */
    private static final class JobFailedException extends IllegalStateException {

        private static final long serialVersionUID = 1;

        JobFailedException(String message) {
            super(message);
        }
    }

    /** The result of a job, or the reason for its failure. */
    private record Outcome<R>(int index, @Nullable R result, String failure) implements Serializable {}

    /** Runs the jobs of a slice on a worker. */
    private static final class Slice<P, R> extends AbstractFunction1<Iterator<Tuple2<Integer, P>>, List<Outcome<R>>>
            implements Serializable {

        private static final long serialVersionUID = 1;

        private final Job<P, R> job;

        Slice(Job<P, R> job) {
            this.job = job;
        }

        @Override
        public List<Outcome<R>> apply(Iterator<Tuple2<Integer, P>> jobs) {
            List<Outcome<R>> outcomes = new ArrayList<>();
            while (jobs.hasNext()) {
                Tuple2<Integer, P> next = jobs.next();
                try {
                    outcomes.add(new Outcome<>(next._1(), job.run(next._2()), ""));
                } catch (Exception failed) {
                    outcomes.add(new Outcome<>(next._1(), null, String.valueOf(failed)));
                }
            }
            return outcomes;
        }
    }

    /** Receives the results of slices on the driver, one slice at a time. */
    private static final class Results<P, R> extends AbstractFunction2<Object, List<Outcome<R>>, BoxedUnit> {

        private final List<P> parameters;
        private final Receiver<? super P, ? super R> receiver;
        private final Object[] results;

        Results(List<P> parameters, Receiver<? super P, ? super R> receiver) {
            this.parameters = parameters;
            this.receiver = receiver;
            this.results = new Object[parameters.size()];
        }

        @Override
        public synchronized BoxedUnit apply(Object slice, List<Outcome<R>> outcomes) {
            for (Outcome<R> outcome : outcomes) {
                R result = outcome.result();
                if (result == null) {
                    throw new JobFailedException(outcome.failure());
                }
                results[outcome.index()] = result;
                try {
                    receiver.accept(parameters.get(outcome.index()), result);
                } catch (IOException unwritable) {
                    throw new UncheckedIOException(unwritable);
                }
            }
            return BoxedUnit.UNIT;
        }

        @SuppressWarnings("unchecked")
        synchronized List<R> inOrder() {
            return (List<R>) Arrays.asList(results);
        }
    }
}
