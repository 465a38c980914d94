package student;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Joint;

/** A program with the mistakes that beginners make; the tests want to read its line numbers. */
public class Careless extends Agent {

    private final Mistake mistake;

    /** One thing that a beginner does wrong. */
    public interface Mistake {
        /** Makes the mistake. */
        void make(Robot nao);
    }

    /** Creates an agent that makes a mistake in each cycle. */
    public Careless(Mistake mistake) {
        this.mistake = mistake;
    }

    @Override
    protected void think() {
        mistake.make(nao);
    }

    /** Divides by zero and gives the result to a motor. */
    public static void speedNaN(Robot nao) {
        double nothing = nao.getGyro().x();
        nao.setJointSpeed(Joint.LEFT_KNEE_PITCH, nothing / nao.getGyro().z());
    }

    /** Bends the knee to the wrong side. */
    public static void beyondRange(Robot nao) {
        nao.setJointAngle(Joint.LEFT_KNEE_PITCH, 200);
    }

    /** Forgets that arrays end. */
    public static void exception(Robot nao) {
        int[] numbers = new int[Joint.COUNT];
        nao.setJointSpeed(Joint.NECK_YAW, numbers[numbers.length]);
    }

    /** Talks too much. */
    public static void longSpeech(Robot nao) {
        nao.say("this-is-much-longer-than-allowed");
    }

    /** Keeps more than there is room for. */
    public static void tooMuch(Robot nao) {
        if (nao.getTime() > 0) {
            throw new OutOfMemoryError("Java heap space");
        }
    }

    /** Uses a class whose fields cannot be prepared. */
    public static void brokenTable(Robot nao) {
        nao.setJointSpeed(Joint.NECK_YAW, Table.SPEED);
    }

    /** Moves a joint that a motion moves, and one that it leaves alone. */
    public static void motionAndCommand(Robot nao) {
        nao.setJointSpeed(Joint.RIGHT_SHOULDER_PITCH, 5);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 5);
    }

    /** Shows a number with a point as a whole one. */
    public static Careless withWrongPattern() {
        return new Careless(nao -> {}) {
            @Override
            protected void think() {
                log.info("angle %d", nao.getJointAngle(Joint.NECK_YAW));
            }
        };
    }

    private static final class Table {
        static final int SPEED = Integer.parseInt("fast");
    }
}
