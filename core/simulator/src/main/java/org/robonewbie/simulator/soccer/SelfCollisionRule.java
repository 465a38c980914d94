package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.simulator.world.Robot;

/** Self-collision foul: limbs of the same robot that collide with each other are frozen for a short time. */
final class SelfCollisionRule implements FoulRule {

    private static final Set<String> ALLOWED = Set.of(
            "body rthigh",
            "body lthigh",
            "rthigh rshank",
            "lthigh lshank",
            "rshank rfoot",
            "lshank lfoot",
            "rfoot rtoe",
            "lfoot ltoe");

    private final Match match;

    SelfCollisionRule(Match match) {
        this.match = match;
    }

    @Override
    public void judge() {
        if (match.parameters().isOn(SoccerParameter.FOUL_ON_SELF_COLLISIONS)) {
            for (Player player : match.players()) {
                if (!player.fouls().isPunished()) {
                    judge(player);
                }
            }
        }
    }

    private void judge(Player player) {
        Robot robot = player.robot();
        List<Integer> boxes = boxes(robot.nao());
        List<OrientedBox> placed =
                boxes.stream().map(link -> OrientedBox.of(robot, link)).toList();
        double tolerance = match.parameters().get(SoccerParameter.SELF_COLLISIONS_TOLERANCE);
        boolean foul = false;
        for (int i = 0; i < placed.size(); i++) {
            for (int j = i + 1; j < placed.size(); j++) {
                if (placed.get(i).overlaps(placed.get(j), tolerance)
                        && !isAllowed(robot.nao(), boxes.get(i), boxes.get(j))) {
                    foul |= punish(player, boxes.get(i), boxes.get(j));
                }
            }
        }
        if (foul) {
            match.referee().report(player, FoulType.SELF_COLLISION);
        }
    }

    private static List<Integer> boxes(NaoModel model) {
        List<Integer> boxes = new ArrayList<>();
        List<Link> links = model.links();
        for (int i = 0; i < links.size(); i++) {
            if (links.get(i).collides() && links.get(i).shape() instanceof Shape.Box) {
                boxes.add(i);
            }
        }
        return boxes;
    }

    private static boolean isAllowed(NaoModel model, int first, int second) {
        return ALLOWED.contains(model.links().get(first).name() + " "
                + model.links().get(second).name());
    }

    /** Punishes a collision; returns whether a hinge was frozen. */
    private boolean punish(Player player, int firstLink, int secondLink) {
        if (match.parameters().isOn(SoccerParameter.SELF_COLLISION_BEAM_PENALTY)) {
            long cooldown = ticks(SoccerParameter.SELF_COLLISION_BEAM_COOLDOWN_TIME);
            if (player.fouls().startSelfCollisionPenalty(match.currentTick(), cooldown)) {
                match.referee().punish(player, FoulType.SELF_COLLISION);
            }
            return false;
        }
        boolean firstFrozen = freeze(player, firstLink);
        boolean secondFrozen = freeze(player, secondLink);
        return firstFrozen || secondFrozen;
    }

    /** Freezes all hinges of a link's limb; the torso does not belong to a limb. */
    private boolean freeze(Player player, int link) {
        NaoModel model = player.robot().nao();
        String limb = limb(model.links().get(link).name());
        List<Hinge> hinges = model.hinges();
        boolean frozen = false;
        for (int i = 0; i < hinges.size(); i++) {
            if (!limb.isEmpty() && hinges.get(i).effectorName().startsWith(limb)) {
                frozen |= player.fouls()
                        .freeze(
                                i,
                                match.currentTick(),
                                ticks(SoccerParameter.SELF_COLLISION_JOINT_FROZEN_TIME),
                                ticks(SoccerParameter.SELF_COLLISION_JOINT_THAW_TIME));
            }
        }
        return frozen;
    }

    /** Returns the common prefix of the effector names of a link's limb, such as {@code rae}; empty for the torso. */
    private static String limb(String link) {
        if (link.equals(NaoModel.TORSO)) {
            return "";
        }
        return link.charAt(0) + (link.endsWith("arm") ? "ae" : "le");
    }

    private long ticks(SoccerParameter seconds) {
        return PortableMath.round(match.parameters().get(seconds) / Cycle.SECONDS);
    }
}
