package org.robonewbie.studio;

import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.telemetry.TuningRequest;

/** Command from a page. */
interface StudioRequest {

    /**
     * Executes the command.
     *
     * @param context the objects on which the command operates
     */
    void applyTo(StudioContext context);

    /** Acknowledgement that the page has drawn its last frame and is ready for the next. */
    record Seen() implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {}
    }

    /**
     * Subscribes to the telemetry of one robot only.
     *
     * @param team name of the robot's team
     * @param number player number of the robot
     */
    record Watch(String team, int number) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {}
    }

    /**
     * Changes a tunable parameter of a robot's program while it runs.
     *
     * @param wish the parameter and its new value
     */
    record Tune(TuningRequest wish) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            context.numbers().put(wish);
        }
    }

    /**
     * Commands that control the world's clock; they cannot be undone.
     *
     * @param orders the commands, in order of execution
     */
    record Orders(List<Order> orders) implements StudioRequest {

        Orders(Order... orders) {
            this(List.of(orders));
        }

        @Override
        public void applyTo(StudioContext context) {
            orders.forEach(context.simulation()::order);
        }
    }

    /**
     * Undoable change to the world.
     *
     * @param name description such as "ball moved"
     * @param gesture number of the drag that the change belongs to; 0 for none
     * @param orders the commands, in order of execution
     */
    record Change(String name, long gesture, List<Order> orders) implements StudioRequest {

        Change(String name, Order... orders) {
            this(name, 0, List.of(orders));
        }

        @Override
        public void applyTo(StudioContext context) {
            context.undoManager().change(name, gesture, () -> orders.forEach(context.simulation()::order));
        }
    }

    /** Undoes the latest change, or redoes the most recently undone one. */
    enum History implements StudioRequest {
        UNDO {
            @Override
            public void applyTo(StudioContext context) {
                context.undoManager().undo();
            }
        },
        REDO {
            @Override
            public void applyTo(StudioContext context) {
                context.undoManager().redo();
            }
        }
    }

    /**
     * Adds a manually controlled robot.
     *
     * @param side team of the robot; ignored if there is no left team yet, because the robot then creates that team
     */
    record AddPuppet(TeamSide side) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            PlayerNumber player = context.puppets().add(side, context.now());
            context.undoManager().puppetAdded(player);
        }
    }

    /**
     * Removes a manually controlled robot.
     *
     * @param player the robot
     */
    record RemovePuppet(PlayerNumber player) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            context.undoManager().removePuppet(player);
        }
    }
}
