package org.robonewbie.agent.motion;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionFormatException;
import org.robonewbie.nao.motion.MotionLibrary;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.MotionProblem;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.nao.text.Spelling;

/**
 * Plays motions in sequence: finds them by name, makes a fallen robot get up first, and inserts transitions such as
 * stopping or starting to walk where a motion cannot directly follow the previous one.
 */
public final class MotionSequencer implements Motions {

    /**
     * Maximum number of motions in a transition: one from any state to the state {@code stance}, and one from there to
     * a walk.
     */
    private static final int MAX_TRANSITIONS = 2;

    private final Motors motors;
    private final MotionLibrary library;
    private final Diagnostics diagnostics;
    private final Supplier<BodyPosition> bodyPosition;
    private final MotionStates states = new MotionStates();
    private final Map<String, MotionFile> lastGood = new HashMap<>();
    private final Deque<MotionFile> queue = new ArrayDeque<>();
    private Interpolation interpolation = Interpolation.LINEAR;
    private Optional<MotionPlayer> player = Optional.empty();
    private double speed = 1;
    private boolean looping;
    private boolean automaticGetUp = true;
    private Optional<MotionFile> playing = Optional.empty();

    /**
     * Creates an idle sequencer.
     *
     * @param motors motors that receive the joint speeds
     * @param library source of motions
     * @param diagnostics receives reports about invalid motions
     * @param bodyPosition supplies the orientation of the torso
     */
    public MotionSequencer(
            Motors motors, MotionLibrary library, Diagnostics diagnostics, Supplier<BodyPosition> bodyPosition) {
        this.motors = motors;
        this.library = library;
        this.diagnostics = diagnostics;
        this.bodyPosition = bodyPosition;
    }

    @Override
    public boolean start(String name) {
        return start(() -> load(name));
    }

    private boolean start(Supplier<Optional<MotionFile>> source) {
        looping &= !isFinished();
        Optional<MotionFile> file = isFinished() ? source.get() : Optional.empty();
        file.ifPresent(this::prepare);
        return file.isPresent();
    }

    @Override
    public boolean loop(String name) {
        boolean starts = start(name);
        looping |= starts;
        return starts;
    }

    @Override
    public boolean startMirrored(String name) {
        return start(() -> load(name).map(file -> file.mirrored(name + " mirrored")));
    }

    @Override
    public void setAutomaticGetUp(boolean on) {
        automaticGetUp = on;
    }

    @Override
    public boolean startGetUp() {
        return bodyPosition.get().isFallen() && start(getUpMotion());
    }

    private String getUpMotion() {
        return switch (bodyPosition.get()) {
            case LYING_ON_FRONT -> "stand-up-from-front";
            case LYING_ON_LEFT_SIDE -> existing("stand-up-from-left-side");
            case LYING_ON_RIGHT_SIDE -> existing("stand-up-from-right-side");
            case LYING_ON_BACK, UPRIGHT -> "stand-up-from-back";
        };
    }

    private String existing(String name) {
        return library.names().contains(name) ? name : "stand-up-from-back";
    }

    @Override
    public boolean start(Motion motion) {
        return start(() -> Optional.of(MotionFile.of(motion)));
    }

    @Override
    public void stop() {
        if (!isFinished()) {
            states.reset();
        }
        queue.clear();
        looping = false;
        player = Optional.empty();
        motors.stopMotion();
    }

    @Override
    public boolean isFinished() {
        return queue.isEmpty() && (player.isEmpty() || player.get().isFinished());
    }

    @Override
    public Optional<String> current() {
        return player.filter(playing -> !isFinished())
                .map(playing -> playing.motion().name());
    }

    /**
     * Returns the name of the motion that is currently moving a joint.
     *
     * @param joint the joint
     * @return the motion's name; empty if no motion is moving the joint
     */
    public Optional<String> turning(Joint joint) {
        return player.filter(playing -> !isFinished() && playing.turns(joint))
                .map(playing -> playing.motion().name());
    }

    @Override
    public int keyframe() {
        return player.filter(playing -> !isFinished())
                .map(playing -> playing.keyframe() + 1)
                .orElse(0);
    }

    @Override
    public void setSpeed(double factor) {
        if (factor > 0 && Double.isFinite(factor)) {
            speed = factor;
        } else {
            diagnostics.report(
                    "motion speed", () -> "A motion cannot be played at speed " + factor + "; use a number above 0.");
        }
    }

    @Override
    public void setInterpolation(Interpolation interpolation) {
        this.interpolation = interpolation;
    }

    @Override
    public void reset() {
        stop();
        states.reset();
    }

    /** Plays one cycle. */
    public void update() {
        if (player.isPresent() && player.get().isFinished()) {
            player = Optional.empty();
        }
        if (looping && player.isPresent() && playing.isPresent() && hasToGetUpFor(playing.get())) {
            prepare(playing.get());
            player = Optional.empty();
        }
        if (player.isEmpty() && !queue.isEmpty()) {
            begin(next());
        } else if (player.isEmpty()) {
            motors.stopMotion();
        }
        if (player.isPresent()) {
            player.get().step(motors);
        }
    }

    private MotionFile next() {
        MotionFile file = queue.remove();
        Optional<MotionFile> getUp = hasToGetUpFor(file) ? load(getUpMotion()) : Optional.empty();
        getUp.ifPresent(way -> queue.addFirst(file));
        return getUp.orElse(file);
    }

    private boolean hasToGetUpFor(MotionFile file) {
        return automaticGetUp && bodyPosition.get().isFallen() && MotionStates.needsFeet(file);
    }

    private void prepare(MotionFile file) {
        boolean lying = bodyPosition.get().isFallen();
        if (hasToGetUpFor(file)) {
            load(getUpMotion()).ifPresent(states::ended); // the get-up motion is played first
            lying = false;
        }
        if (!lying) {
            addTransitionsTo(file);
        }
        enqueue(file);
    }

    private void enqueue(MotionFile file) {
        queue.add(file);
        states.ended(file);
    }

    /**
     * Inserts transitions to the start state of a motion: a single one if possible, otherwise one to the state {@code
     * stance} and one from there.
     */
    private void addTransitionsTo(MotionFile file) {
        for (int i = 0; i < MAX_TRANSITIONS && !states.canStart(file); i++) {
            List<MotionFile> possible =
                    transitions(file).filter(states::canStart).toList();
            possible.stream()
                    .filter(transition -> MotionStates.canStartAfter(transition, file))
                    .findFirst()
                    .or(() -> states.isStance()
                            ? Optional.empty()
                            : possible.stream().findFirst())
                    .ifPresent(this::enqueue);
        }
    }

    private Stream<MotionFile> transitions(MotionFile file) {
        return MotionStates.TRANSITIONS.stream()
                .filter(name -> !name.equals(file.motion().name()))
                .flatMap(name -> load(name).stream());
    }

    private void begin(MotionFile file) {
        motors.release();
        MotionPlayer next = MotionPlayer.of(file, speed, interpolation);
        next.setLooping(looping && queue.isEmpty());
        if (speed != 1 || !library.isShipped(file)) {
            reportProblems(next, file);
        }
        player = Optional.of(next);
        playing = Optional.of(file);
    }

    /**
     * Reports joint speeds that the motors cannot reach. Shipped motions are skipped, because they are tested and a
     * kick may use a motor's full speed.
     */
    private void reportProblems(MotionPlayer next, MotionFile file) {
        int fromKeyframe = file.property("start").isPresent() ? 1 : 0;
        for (String problem : next.problems(motors, fromKeyframe)) {
            String kind = "too fast " + next.motion().name() + problem.replaceAll("[0-9]+", "");
            diagnostics.reportAt("", kind, () -> problem);
        }
    }

    private Optional<MotionFile> load(String name) {
        try {
            Optional<MotionFile> file = library.find(name);
            if (file.isEmpty()) {
                diagnostics.reportSerious("motion " + name + ": unknown", () -> unknown(name));
            }
            file.ifPresent(this::check);
            file.ifPresent(good -> {
                lastGood.put(name, good);
                diagnostics.forgive("motion " + name + ": ");
            });
            return file;
        } catch (IOException | MotionFormatException broken) {
            boolean known = lastGood.containsKey(name);
            String kind = "motion " + name + ": " + broken.getMessage();
            Supplier<String> text = () -> "The motion " + name + " cannot be played: " + broken.getMessage()
                    + (known ? ". The last valid version is played." : ". The robot continues without it.");
            if (known) {
                diagnostics.report(kind, text);
            } else {
                diagnostics.reportSerious(kind, text);
            }
            return Optional.ofNullable(lastGood.get(name));
        }
    }

    /**
     * Reports values that the robot cannot play exactly as written in the file; throws an exception if the file is
     * invalid.
     */
    private void check(MotionFile file) {
        file.motion();
        for (MotionProblem finding : file.warnings()) {
            String text = file.name() + " " + finding;
            diagnostics.reportAt("", text, () -> text + "; the robot plays it within its limits.");
        }
    }

    private String unknown(String name) {
        SortedSet<String> names = library.names();
        String plain = name.replaceFirst("(?i)\\.txt$", "");
        String others = "use one of: " + String.join(", ", names) + ".";
        if (!plain.equals(name) && names.contains(plain)) {
            return String.format(
                    Locale.ROOT, "There is no motion \"%s\". Omit \".txt\": the name is \"%s\".", name, plain);
        }
        Optional<String> problem = FileName.problem(plain);
        if (problem.isPresent()) {
            return String.format(
                    Locale.ROOT,
                    "\"%s\" is not a valid motion name: it %s.%s Choose another name, or %s",
                    name,
                    problem.get(),
                    meant(plain, names),
                    others);
        }
        return String.format(
                Locale.ROOT,
                "There is no motion \"%s\".%s Put a file motions/%s.txt in the working directory, or %s",
                name,
                Spelling.question(plain, names, similar -> "\"" + similar + "\""),
                plain,
                others);
    }

    /** Returns a question that suggests a valid name for an invalid one. */
    private static String meant(String name, SortedSet<String> names) {
        return Spelling.nearest(name.strip(), names)
                .or(() -> names.contains(name.strip()) ? Optional.of(name.strip()) : Optional.empty())
                .map(similar -> " Did you mean \"" + similar + "\"?")
                .orElse("");
    }
}
