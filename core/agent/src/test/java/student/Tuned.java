package student;

import org.robonewbie.agent.Agent;

/** A program whose numbers stand in fields, are computed further, lead to other objects, or are asked for in each cycle. */
public final class Tuned extends Agent {

    private final double gain = number("gain", 0.5, 0, 1);
    private final double half = gain / 2;
    private final Distance near = new Distance(number("near", 0.3, 0.1, 0.8));
    private int cycles;

    @Override
    protected void think() {
        cycles++;
        nao.plot("cycles", cycles);
        nao.plot("gain", gain);
        nao.plot("half", half);
        nao.plot("near", near.metres);
        nao.plot("asked", number("asked", 1, 0, 10));
    }

    /** An object of the program that remembers something. */
    private static final class Distance {

        private final double metres;

        Distance(double metres) {
            this.metres = metres;
        }
    }

    /** The same without a constructor that could make another one. */
    public static final class Named extends Agent {

        private final double gain = number("gain", 0.5, 0, 1);

        /**
         * Creates a robot.
         *
         * @param name of no use
         */
        public Named(String name) {}

        @Override
        protected void think() {
            nao.plot("gain", gain);
            nao.plot("asked", number("gain", 0.5, 0, 1));
        }
    }
}
