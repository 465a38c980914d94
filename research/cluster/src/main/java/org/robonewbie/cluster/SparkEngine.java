package org.robonewbie.cluster;

import java.io.Serializable;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.jspecify.annotations.Nullable;
import org.robonewbie.learning.series.CollectedTrials;
import org.robonewbie.learning.series.Experiment;
import org.robonewbie.learning.series.ExperimentEngine;
import org.robonewbie.learning.series.PlannedTrial;
import org.robonewbie.learning.series.TrialSink;
import scala.collection.Iterator;
import scala.reflect.ClassTag$;
import scala.runtime.AbstractFunction1;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/**
 * Carries out trials on a Spark cluster. Trials go out in small slices; a slice whose computer is lost is carried out again
 * elsewhere. The results of a slice come back as soon as it is done.
 */
public final class SparkEngine implements ExperimentEngine {

    private static final int TRIALS_PER_SLICE = 10;
    private static final int MOST_SLICES = 10_000;

    private @Nullable JavaSparkContext context;

    /** Creates the engine; Spark starts with the first trial and ends with {@link #close}. */
    public SparkEngine() {}

    @Override
    public String label() {
        return "spark";
    }

    @Override
    public List<double[]> run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress) {
        CollectedTrials all = new CollectedTrials();
        run(experiment, trials, master, progress, all);
        return all.of(trials);
    }

    @Override
    public void run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress, TrialSink sink) {
        if (trials.isEmpty()) {
            return;
        }
        JavaSparkContext spark = context(experiment, master);
        int slices = Math.max(
                Math.min(trials.size(), spark.defaultParallelism()),
                Math.min(MOST_SLICES, trials.size() / TRIALS_PER_SLICE));
        try {
            spark.sc()
                    .runJob(
                            spark.parallelize(new ArrayList<>(trials), slices).rdd(),
                            new Slice(experiment),
                            new Results(trials, progress, sink),
                            ClassTag$.MODULE$.apply(List.class));
        } catch (Exception failed) {
            throw unchecked(failed);
        }
    }

    /** Spark throws checked exceptions without declaring them; a disk that is full comes back as it was thrown. */
    private static RuntimeException unchecked(Exception failed) {
        if (failed.getCause() instanceof UncheckedIOException full) {
            return full;
        }
        return new IllegalStateException("Spark has given up: " + failed.getMessage(), failed);
    }

    private JavaSparkContext context(String experiment, String master) {
        JavaSparkContext spark = context;
        if (spark == null) {
            SparkConf settings = new SparkConf()
                    .setAppName("RoboNewbie " + experiment)
                    .setIfMissing("spark.task.maxFailures", "8")
                    .setIfMissing("spark.ui.enabled", "false");
            if (!master.isEmpty()) {
                settings.setMaster(master);
            }
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

    /** What came of a trial: its numbers, or why there are none. */
    private record Outcome(int number, List<Double> numbers, String failure) implements Serializable {}

    /** What a worker does. */
    private static final class Slice extends AbstractFunction1<Iterator<PlannedTrial>, List<Outcome>>
            implements Serializable {

        private static final long serialVersionUID = 1;

        private final String experiment;

        Slice(String experiment) {
            this.experiment = experiment;
        }

        @Override
        public List<Outcome> apply(Iterator<PlannedTrial> trials) {
            List<Outcome> outcomes = new ArrayList<>();
            while (trials.hasNext()) {
                outcomes.add(outcome(trials.next()));
            }
            return outcomes;
        }

        private Outcome outcome(PlannedTrial trial) {
            Experiment carriedOut = Experiment.of(experiment);
            try {
                return new Outcome(
                        trial.number(),
                        DoubleStream.of(trial.run(carriedOut)).boxed().toList(),
                        "");
            } catch (IllegalStateException failed) {
                return new Outcome(trial.number(), List.of(), String.valueOf(failed.getMessage()));
            }
        }
    }

    /** Passes on what comes back, one slice after the other. */
    private static final class Results extends AbstractFunction2<Object, List<Outcome>, BoxedUnit> {

        private final Map<Integer, PlannedTrial> trials;
        private final IntConsumer progress;
        private final TrialSink sink;
        private int done;

        Results(List<PlannedTrial> trials, IntConsumer progress, TrialSink sink) {
            this.trials = trials.stream().collect(Collectors.toMap(PlannedTrial::number, Function.identity()));
            this.progress = progress;
            this.sink = sink;
        }

        @Override
        public synchronized BoxedUnit apply(Object slice, List<Outcome> outcomes) {
            for (Outcome outcome : outcomes) {
                PlannedTrial trial = Objects.requireNonNull(trials.get(outcome.number()));
                if (outcome.failure().isEmpty()) {
                    sink.measured(
                            trial,
                            outcome.numbers().stream()
                                    .mapToDouble(Double::doubleValue)
                                    .toArray());
                } else {
                    sink.failed(trial, outcome.failure());
                }
            }
            done += outcomes.size();
            progress.accept(done);
            return BoxedUnit.UNIT;
        }
    }
}
