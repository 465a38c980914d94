package org.robonewbie.agent.motion;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.log.Spelling;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionFinding;
import org.robonewbie.nao.motion.MotionFormatException;

/**
 * Plays motions by name, one after the other. A motion that has started runs to its end; another one can start when {@link
 * #isFinished}. It begins from wherever the robot is; where it would begin in the middle of a step, the robot first stops, and
 * before a walk it makes a first step.
 *
 * <pre>{@code
 * if (motions.isFinished()) {
 *     motions.start(ballIsAhead ? "walk-forward" : "turn-left");
 * }
 * }</pre>
 *
 * <p>A file says in the comments {@code // start: stance} and {@code // end: stance} between which postures it leads; from
 * {@code // end: walking} the robot stops before it turns. Without a comment a motion starts when the robot stands still.
 *
 * <p>A fallen robot first gets up when a motion starts whose file says that it starts on the feet.
 *
 * <p>A joint that you command while a motion runs is yours until the next motion starts.
 */
public final class Motions {

    /** From any state to the stance, and from there to a walk. */
    private static final int MOST_BRIDGES = 2;

    private final Motors motors;
    private final MotionLibrary library;
    private final Mistakes mistakes;
    private final Supplier<BodyPosition> bodyPosition;
    private final MotionStates states = new MotionStates();
    private final Map<String, MotionFile> lastGood = new HashMap<>();
    private final Deque<MotionFile> queue = new ArrayDeque<>();
    private Interpolation interpolation = Interpolation.LINEAR;
    private Optional<MotionPlayer> player = Optional.empty();
    private double speed = 1;
    private boolean looping;
    private boolean gettingUp = true;
    private Optional<MotionFile> playing = Optional.empty();

    /**
     * Creates a player; the framework does this for each robot.
     *
     * @param motors take the speeds
     * @param library knows the motions
     * @param mistakes takes what is wrong with a motion
     * @param bodyPosition tells whether the robot lies on the ground
     */
    public Motions(Motors motors, MotionLibrary library, Mistakes mistakes, Supplier<BodyPosition> bodyPosition) {
        this.motors = motors;
        this.library = library;
        this.mistakes = mistakes;
        this.bodyPosition = bodyPosition;
    }

    /**
     * Starts a motion, unless another one is still running.
     *
     * @param name its file is {@code motions/NAME.txt} in the working directory or comes with the framework
     * @return whether the motion starts; false while another one runs, and with a report if there is no such motion; a file
     *     that was broken since it was last played is reported and played as it was
     */
    public boolean start(String name) {
        looping &= !isFinished();
        return isFinished() && load(name).filter(this::prepare).isPresent();
    }

    /**
     * Starts a motion that begins again after its end until {@link #stop} is called.
     *
     * @param name as in {@link #start}
     * @return whether the motion starts
     */
    public boolean loop(String name) {
        boolean starts = start(name);
        looping |= starts;
        return starts;
    }

    /**
     * Starts the mirror image of a motion, with left and right exchanged.
     *
     * @param name as in {@link #start}; the file {@code NAME.txt} is played in the mirror
     * @return whether the motion starts
     */
    public boolean startMirrored(String name) {
        looping &= !isFinished();
        return isFinished()
                && load(name)
                        .map(file -> MotionLibrary.mirrored(file, name + " mirrored"))
                        .filter(this::prepare)
                        .isPresent();
    }

    /**
     * Chooses whether a fallen robot gets up by itself before it plays a motion that starts on the feet; at first it does.
     *
     * @param on false lets each motion begin as the robot lies
     */
    public void setAutomaticGetUp(boolean on) {
        gettingUp = on;
    }

    /**
     * Starts the motion that brings a fallen robot to its feet: {@code stand-up-from-back}, {@code stand-up-from-front},
     * {@code stand-up-from-left-side} or {@code stand-up-from-right-side}; who has no motion for the side tries that for the back.
     *
     * @return whether it starts; false if the robot is upright or another motion is running
     */
    public boolean startGetUp() {
        return bodyPosition.get().isFallen() && start(wayUp());
    }

    private String wayUp() {
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

    /**
     * Starts a motion that was made by the program, unless another one is still running.
     *
     * @param motion the motion
     * @return whether it starts
     */
    public boolean start(Motion motion) {
        looping &= !isFinished();
        return isFinished() && prepare(MotionFile.of(motion));
    }

    /** Stops the running motion where it is; a walking robot may fall. */
    public void stop() {
        if (!isFinished()) {
            states.reset();
        }
        queue.clear();
        looping = false;
        player = Optional.empty();
        MotionPlayer.stop(motors);
    }

    /**
     * Tells whether a new motion can start.
     *
     * @return whether the last motion has run to its end, or none was started
     */
    public boolean isFinished() {
        return queue.isEmpty() && (player.isEmpty() || player.get().isFinished());
    }

    /**
     * Names the running motion.
     *
     * @return its name; empty if none is running
     */
    public Optional<String> current() {
        return player.filter(playing -> !isFinished())
                .map(playing -> playing.motion().name());
    }

    /**
     * Tells which keyframe of the running motion the robot approaches.
     *
     * @return its number from 1; 0 if no motion is running
     */
    public int keyframe() {
        return player.filter(playing -> !isFinished())
                .map(playing -> playing.keyframe() + 1)
                .orElse(0);
    }

    /**
     * Plays motions slower or faster, from the next start on.
     *
     * @param factor 1 as in the file, 2 twice as fast; only numbers above 0 count
     */
    public void setSpeed(double factor) {
        if (factor > 0 && Double.isFinite(factor)) {
            speed = factor;
        } else {
            mistakes.report("motion speed", () -> "Motions cannot have speed " + factor + "; use a number above 0.");
        }
    }

    /**
     * Moves between keyframes in another way, from the next start on.
     *
     * @param interpolation such as a spline
     */
    public void setInterpolation(Interpolation interpolation) {
        this.interpolation = interpolation;
    }

    /** The robot was put somewhere else: no motion goes on. */
    public void reset() {
        stop();
        states.reset();
    }

    /** Plays one cycle; the framework does this when the robot acts. */
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
            MotionPlayer.stop(motors);
        }
        if (player.isPresent()) {
            player.get().step(motors);
        }
    }

    private MotionFile next() {
        MotionFile file = queue.remove();
        Optional<MotionFile> getUp = hasToGetUpFor(file) ? load(wayUp()) : Optional.empty();
        getUp.ifPresent(way -> queue.addFirst(file));
        return getUp.orElse(file);
    }

    private boolean hasToGetUpFor(MotionFile file) {
        return gettingUp && bodyPosition.get().isFallen() && MotionStates.needsFeet(file);
    }

    private boolean prepare(MotionFile file) {
        boolean lying = bodyPosition.get().isFallen();
        if (hasToGetUpFor(file)) {
            load(wayUp()).ifPresent(states::ended); // it will be played first
            lying = false;
        }
        if (!lying) {
            bridgeTo(file);
        }
        prepareNow(file);
        return true;
    }

    private void prepareNow(MotionFile file) {
        queue.add(file);
        states.ended(file);
    }

    /** Leads to the start of a motion: directly if one bridge does it, otherwise by way of the stance. */
    private void bridgeTo(MotionFile file) {
        for (int i = 0; i < MOST_BRIDGES && !states.canStart(file); i++) {
            List<MotionFile> possible = bridges(file).filter(states::canStart).toList();
            possible.stream()
                    .filter(bridge -> MotionStates.canStartAfter(bridge, file))
                    .findFirst()
                    .or(() -> states.isStance()
                            ? Optional.empty()
                            : possible.stream().findFirst())
                    .ifPresent(this::prepareNow);
        }
    }

    private Stream<MotionFile> bridges(MotionFile file) {
        return MotionStates.BRIDGES.stream()
                .filter(name -> !name.equals(file.motion().name()))
                .flatMap(name -> load(name).stream());
    }

    private void begin(MotionFile file) {
        motors.release();
        Motion motion = speed == 1 ? file.motion() : file.motion().stretched(1 / speed);
        MotionPlayer next = new MotionPlayer(motion, interpolation);
        next.setLooping(looping && queue.isEmpty());
        if (speed != 1 || !library.isShipped(file)) {
            reportProblems(next, file);
        }
        player = Optional.of(next);
        playing = Optional.of(file);
    }

    /** What comes with the framework was tried; a kick may well ask for all that a motor can give. */
    private void reportProblems(MotionPlayer next, MotionFile file) {
        int fromKeyframe = file.property("start").isPresent() ? 1 : 0;
        for (String problem : next.problems(motors, fromKeyframe)) {
            String kind = "too fast " + next.motion().name() + problem.replaceAll("[0-9]+", "");
            mistakes.reportAt("", kind, () -> problem);
        }
    }

    private Optional<MotionFile> load(String name) {
        try {
            Optional<MotionFile> file = library.find(name);
            if (file.isEmpty()) {
                mistakes.report("unknown motion " + name, () -> unknown(name));
            }
            file.ifPresent(this::check);
            file.ifPresent(good -> lastGood.put(name, good));
            return file;
        } catch (IOException | MotionFormatException broken) {
            boolean known = lastGood.containsKey(name);
            mistakes.report(
                    "broken motion " + name + broken.getMessage(),
                    () -> "The motion " + name + " cannot be played: " + broken.getMessage()
                            + (known ? ". The robot plays it as it was before." : ". The robot goes on without it."));
            return Optional.ofNullable(lastGood.get(name));
        }
    }

    /** Reports what the robot cannot do quite as the file says; throws if the file cannot be understood at all. */
    private void check(MotionFile file) {
        file.motion();
        for (MotionFinding finding : file.warnings()) {
            String text = file.name() + " " + finding;
            mistakes.reportAt("", text, () -> text + "; the robot does what it can.");
        }
    }

    private String unknown(String name) {
        String meant = Spelling.nearest(name.replaceFirst("\\.txt$", ""), library.names())
                .map(similar -> " Did you mean \"" + similar + "\"?")
                .orElse("");
        return String.format(
                Locale.ROOT,
                "There is no motion \"%s\".%s Put a file motions/%s.txt into the working directory, or use one of: %s.",
                name,
                meant,
                name,
                String.join(", ", library.names()));
    }
}
