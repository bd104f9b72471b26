#!/usr/bin/env python3
"""An elastic rod in a curved hole, in three dimensions: the reference of check_rod.py. It shares no formulation with the program.

State of a section: place r, unit tangent t, force F and moment M that the part below exerts on the part above (12 numbers).
With s, the unstretched length from the top:

    r' = (1 + F.t/EA) t                  stretch
    t' = (M/EI + k0) x t                 bending, k0: curvature before loading; torque -M.t
    F' = -w - f                          weight in mud, wall
    M' = -r' x F - m                     couple of friction

    f = R (-n + a u - b tau),  m = -c R (a tau + b u)      with the hole axis' tangent u, outward n, tau = u x n
    R = G (|offset| - clearance) per length, c: radius that touches, a and b: signed axial and rotary friction

The hole is arcs and straights through the stations (minimum curvature). A point's foot on an arc follows from the arc's centre.
Equations hold by Simpson's rule in each interval (Lobatto, fourth order). Intervals end at every change of string, hole and arc.
Newton's method with derivatives by complex steps; walls get stiffer by stages. Ends are on the axis and free to rotate.

The wall has one stiffness, so a deck must set gk_contact = gk_max. Units: SI. Needs numpy and scipy.
"""
import numpy as np
from scipy.linalg import solve_banded

GRAVITY, YOUNGS, POISSON, STEEL = 9.80665, 206.0e9, 0.3, 7850.0
STATE = 12                          # numbers of a section
HALF = STATE//2                     # conditions at an end
BEND_LENGTH = 0.1                   # of a bent housing [m]
STAGES = (1.0e-3, 3.0e-2, 1.0)    # of the wall's stiffness, first without friction
MOST_ITERATIONS, LONGEST_STEP, STILL = 80, 0.05, 1.0e-9


def cross(a, b):
    """Vector product over the last axis."""
    return np.stack([a[..., 1]*b[..., 2] - a[..., 2]*b[..., 1], a[..., 2]*b[..., 0] - a[..., 0]*b[..., 2],
                     a[..., 0]*b[..., 1] - a[..., 1]*b[..., 0]], axis=-1)


def dot(a, b):
    """Scalar product over the last axis, which is kept. Not conjugated."""
    return (a*b).sum(axis=-1, keepdims=True)


def length_of(a):
    """Length over the last axis, which is kept; differentiable at zero."""
    return np.sqrt(dot(a, a) + 1.0e-40)


def high_side(tangent):
    """Unit vector across a tangent that points most upwards; north in a vertical hole."""
    up = np.array([0.0, 0.0, -1.0]) - tangent*(-tangent[..., 2:3])
    if np.linalg.norm(up) < 1.0e-6:
        up = np.array([1.0, 0.0, 0.0]) - tangent*tangent[..., 0:1]
    return up/np.linalg.norm(up)


class Hole:
    """Axis of a hole through stations (depth [m], inclination, azimuth [deg]); axes north, east, down."""

    def __init__(self, depth, inclination, azimuth):
        inclination, azimuth = np.radians(inclination), np.radians(azimuth)
        tangent = np.stack([np.sin(inclination)*np.cos(azimuth), np.sin(inclination)*np.sin(azimuth), np.cos(inclination)], 1)
        self.depth = np.asarray(depth, float)
        arcs = len(self.depth) - 1
        self.tangent, self.side = tangent[:-1], np.zeros((arcs, 3))
        self.radius, self.start = np.zeros(arcs), np.zeros((arcs + 1, 3))
        for k in range(arcs):
            length = self.depth[k + 1] - self.depth[k]
            turn = np.arctan2(np.linalg.norm(np.cross(tangent[k], tangent[k + 1])), tangent[k] @ tangent[k + 1])
            if turn < 1.0e-9:
                self.start[k + 1] = self.start[k] + length*tangent[k]
                continue
            side = tangent[k + 1] - (tangent[k] @ tangent[k + 1])*tangent[k]
            self.side[k], self.radius[k] = side/np.linalg.norm(side), length/turn
            self.start[k + 1] = self.start[k] + self.radius[k]*(np.sin(turn)*tangent[k] + (1.0 - np.cos(turn))*self.side[k])

    def on_axis(self, depth):
        """Place and tangent at depths, and the curvature vector."""
        k = np.clip(np.searchsorted(self.depth, depth, "right") - 1, 0, len(self.radius) - 1)
        along, bent = (depth - self.depth[k])[:, None], self.radius[k][:, None] > 0.0
        radius = np.where(bent, self.radius[k][:, None], 1.0)
        sine, cosine = np.sin(along/radius), np.cos(along/radius)
        place = np.where(bent, radius*(sine*self.tangent[k] + (1.0 - cosine)*self.side[k]), along*self.tangent[k])
        tangent = np.where(bent, cosine*self.tangent[k] + sine*self.side[k], self.tangent[k])
        curvature = np.where(bent, (cosine*self.side[k] - sine*self.tangent[k])/radius, 0.0)
        return self.start[k] + place, tangent, curvature

    def foot(self, place, arc):
        """Offset of places from the axis, tangent and depth there, by the arcs on which the feet are near."""
        for _ in range(3):
            away = place - self.start[arc]
            along, aside = dot(away, self.tangent[arc]), dot(away, self.side[arc])
            bent = self.radius[arc][..., None] > 0.0
            radius = np.where(bent, self.radius[arc][..., None], 1.0)
            # polar coordinates about the arc's centre
            reach = np.sqrt(along*along + (radius - aside)**2)
            sine, cosine = along/reach, (radius - aside)/reach
            depth = np.where(bent, radius*np.arctan2(sine.real, cosine.real), along.real)[..., 0] + self.depth[arc]
            step = (depth > self.depth[arc + 1]).astype(int) - (depth < self.depth[arc]).astype(int)
            next_arc = np.clip(arc + step, 0, len(self.radius) - 1)
            if np.array_equal(next_arc, arc):
                break
            arc = next_arc
        tangent = np.where(bent, cosine*self.tangent[arc] + sine*self.side[arc], self.tangent[arc])
        offset = np.where(bent, away - (radius*sine)*self.tangent[arc] - (radius*(1.0 - cosine))*self.side[arc],
                          away - along*self.tangent[arc])
        return offset, tangent, depth


class Rod:
    """A string in a hole. `case` is a dictionary of check_rod.py; `fine` scales the length of intervals [-]."""

    def __init__(self, case, fine=1.0):
        self.hole = Hole(*case["survey"])
        self.case, self.sections = case, case["holes"]
        self.axial = {"trip_out": 1.0, "trip_in": -1.0, "sliding_drilling": -1.0}.get(case["operation"], 0.0)
        self.rotary = 1.0 if case["operation"] == "rotary_drilling" else 0.0
        self.wall, self.stage, self.rubbing = case["wall"]*1.0e3, 1.0, 1.0
        self.cut(fine)
        self.fill()

    def cut(self, fine):
        """Depths of the sections: every change of string, hole and arc, and short intervals beside blades and bit."""
        bit, upper, ends, edges = self.case["bit"], self.case["bit"], [0.0, self.case["bit"]], []
        self.parts = []
        for part in self.case["string"]:
            lower, upper = upper, (upper - part["length"] if part["length"] else 0.0)
            self.parts.append((upper, lower, part))
            ends += [upper]
            if "bend" in part:
                middle = lower - part["bend_position"]
                ends += [middle - 0.5*BEND_LENGTH, middle + 0.5*BEND_LENGTH]
            if part.get("kind") == "stabilizer":
                edges += [upper, lower] + ([middle - 0.5*BEND_LENGTH, middle + 0.5*BEND_LENGTH] if "bend" in part else [])
        edges += [bit]
        ends += list(self.hole.depth) + [top for top, _, _, _ in self.sections]
        edges += [top for top, _, _, _ in self.sections if top > 0.0]
        marks = np.unique(np.round([d for d in ends if 0.0 <= d <= bit], 9))
        depths = [0.0]
        for begin, end in zip(marks[:-1], marks[1:]):
            # lengths grow with the distance from an edge or from another change
            at, most = begin, []
            while at < end - 1.0e-9:
                near = min(abs(np.array(edges) - at).min(), abs(np.array(edges) - at - 0.05).min())
                change = min(at - marks[marks <= at + 1.0e-9][-1], abs(end - at))
                size = fine*min(0.01 + 0.12*near, 0.1 + 0.15*change, self.case.get("longest", 1.0))
                most.append(size)
                at += size
            most = np.cumsum(most)
            depths += list(begin + most/most[-1]*(end - begin))
        self.s = np.array(depths)

    def fill(self):
        """Properties of the intervals, and the string along the axis as a start."""
        case, s = self.case, self.s
        self.h = np.diff(s)
        count, middle = len(self.h), 0.5*(s[1:] + s[:-1])
        self.ea, self.ei, self.weight, self.touch = (np.zeros(count) for _ in range(4))
        self.bore, self.od, self.bent = np.zeros(count), np.zeros(count), np.zeros((count, 3))
        for upper, lower, part in self.parts:
            here = (middle > upper) & (middle < lower)
            self.ea[here] = YOUNGS*np.pi/4.0*(part["od"]**2 - part["id"]**2)
            self.ei[here] = YOUNGS*np.pi/64.0*(part["od"]**4 - part["id"]**4)
            self.weight[here] = GRAVITY*part["mass"]*(1.0 - case["mud"]/STEEL)
            self.touch[here], self.bore[here], self.od[here] = part.get("touch", part["od"]), part["id"], part["od"]
            if "bend" in part:
                at = lower - part["bend_position"]
                _, tangent, _ = self.hole.on_axis(np.array([at]))
                up, face = high_side(tangent[0]), np.radians(case["toolface"])
                aim = np.cos(face)*up + np.sin(face)*np.cross(tangent[0], up)
                self.bent[abs(middle - at) < 0.5*BEND_LENGTH] = np.radians(part["bend"])/BEND_LENGTH*np.cross(tangent[0], aim)
        self.arc = np.clip(np.searchsorted(self.hole.depth, middle) - 1, 0, len(self.hole.radius) - 1)
        place, tangent, curvature = self.hole.on_axis(s)
        self.ends = place[0], tangent[0]
        tension = np.zeros(len(s))
        tension[:-1] = np.cumsum((self.weight*np.diff(place[:, 2]))[::-1])[::-1]
        stiffness = np.append(self.ei, self.ei[-1])[:, None]
        force, moment = (tension - case["wob"])[:, None]*tangent, stiffness*np.cross(tangent, curvature)
        moment = moment - case["tob"]*tangent
        self.y = np.concatenate([place, tangent, force, moment], axis=1)
        self.scale = np.concatenate([np.full(3, 1.0e-2), np.full(3, 1.0e-2), np.full(3, 1.0e4), np.full(3, 1.0e3)])

    def wall_force(self, place):
        """Contact per length in every interval at places in it, its direction, friction and the hole's tangent."""
        offset, tangent, depth = self.hole.foot(place, np.broadcast_to(self.arc, place.shape[:-1]))
        diameter, friction = np.zeros(depth.shape), np.zeros(depth.shape)
        for top, bottom, bore, factor in self.sections:
            here = ((depth >= top) | (top <= 0.0)) & ((depth < bottom) | (bottom >= self.s[-1]))
            diameter[here], friction[here] = bore, factor
        away = length_of(offset)
        gap = away[..., 0] - 0.5*(diameter - self.touch)
        press = np.where(gap.real > 0.0, self.stage*self.wall*gap, 0.0)[..., None]
        return press, offset/away, tangent, self.rubbing*friction[..., None]

    def slope(self, y):
        """Derivative of the state by s in every interval, with the interval's properties."""
        tangent, force, moment = y[..., 3:6], y[..., 6:9], y[..., 9:12]
        press, out, along, friction = self.wall_force(y[..., 0:3])
        around = cross(along, out)
        onward = (1.0 + dot(force, tangent)/self.ea[:, None])*tangent
        wall = press*(-out + friction*(self.axial*along - self.rotary*around))
        couple = -0.5*self.touch[:, None]*press*friction*(self.axial*around + self.rotary*along)
        wall[..., 2] += self.weight
        return np.concatenate([onward, cross(moment/self.ei[:, None] + self.bent, tangent), -wall,
                               -cross(onward, force) - couple], axis=-1)

    def defect(self, left, right, first, last):
        """What states at both ends of the intervals, and their slopes, leave of the equations, by Simpson's rule."""
        h = self.h[:, None]
        middle = 0.5*(left + right) + h/8.0*(first - last)
        return right - left - h/6.0*(first + 4.0*self.slope(middle) + last)

    def conditions(self, top, bottom):
        """Six conditions at either end, for a stack of states."""
        place, tangent = self.ends
        e1 = high_side(tangent)
        e2 = np.cross(tangent, e1)
        at_top = np.concatenate([top[..., 0:3] - place, dot(top[..., 3:6], top[..., 3:6]) - 1.0,
                                 dot(top[..., 9:12], e1), dot(top[..., 9:12], e2)], axis=-1)
        offset, along, _ = self.hole.foot(bottom[..., None, 0:3], np.broadcast_to(self.arc[-1:], bottom.shape[:-1] + (1,)))
        offset, along = offset[..., 0, :], along[..., 0, :]
        e1 = high_side(along.real.reshape(-1, 3)[0])
        e2 = np.cross(along.real.reshape(-1, 3)[0], e1)
        at_bit = bottom[..., 3:6]
        turned = bottom[..., 9:12] + self.case["tob"]*at_bit
        at_bottom = np.concatenate([dot(offset, e1), dot(offset, e2), dot(bottom[..., 6:9], along) + self.case["wob"],
                                    turned], axis=-1)
        return at_top, at_bottom

    def derivatives(self, y):
        """Residual, and the matrix as bands: six conditions, the intervals, six conditions."""
        count, size = len(self.h), y.size
        step = 1.0e-30j*np.eye(STATE)*self.scale
        left, right = y[:-1], y[1:]
        first, last = self.slope(left), self.slope(right)
        aside = left + step[:, None, :]
        by_left = self.defect(aside, right, self.slope(aside), last).imag/1.0e-30
        aside = right + step[:, None, :]
        by_right = self.defect(left, aside, first, self.slope(aside)).imag/1.0e-30
        top, _ = self.conditions(y[0] + step, y[-1] + 0.0*step)
        _, bottom = self.conditions(y[0] + 0.0*step, y[-1] + step)
        width = STATE + HALF - 1
        bands = np.zeros((2*width + 1, size))
        interval = np.arange(count)
        for j in range(STATE):
            for i in range(STATE):
                for block, columns in ((by_left, STATE*interval + j), (by_right, STATE*(interval + 1) + j)):
                    rows = HALF + STATE*interval + i
                    bands[width + rows - columns, columns] = block[j, :, i]/self.scale[i]
            for i in range(HALF):
                bands[width + i - j, j] = top[j, i].imag/1.0e-30
                row, column = size - HALF + i, size - STATE + j
                bands[width + row - column, column] = bottom[j, i].imag/1.0e-30
        at_top, at_bottom = self.conditions(y[0], y[-1])
        residual = np.concatenate([at_top, (self.defect(left, right, first, last)/self.scale).ravel(), at_bottom])
        return residual, bands, width

    def newton(self):
        """Whether the iteration came to an end."""
        for _ in range(MOST_ITERATIONS):
            residual, bands, width = self.derivatives(self.y)
            step = solve_banded((width, width), bands, -residual).reshape(self.y.shape)*self.scale
            _, tangent, _ = self.hole.on_axis(self.s)
            aside = step[:, 0:3] - dot(step[:, 0:3], tangent)*tangent
            largest = np.sqrt((aside**2).sum(1)).max()
            self.y = self.y + min(1.0, LONGEST_STEP/largest)*step
            if largest < STILL*(1.0 if self.stage == 1.0 else 1.0e5):
                return True
        return False

    def solve(self):
        """Whether an equilibrium was found."""
        found = True
        self.stage, self.rubbing = STAGES[0], 0.0
        self.newton()
        self.rubbing = 1.0
        for self.stage in STAGES:
            found = self.newton()
        return found

    def figures(self):
        """Hook load, torque, sum of contact, largest moment, von Mises stress, side force and tilt at the bit [kN, kN.m, MPa, deg]."""
        y, h = self.y, self.h[:, None]
        first, last = self.slope(y[:-1]), self.slope(y[1:])
        middle = 0.5*(y[:-1] + y[1:]) + h/8.0*(first - last)
        press = [self.wall_force(state[:, 0:3])[0][:, 0] for state in (y[:-1], middle, y[1:])]
        contact = (self.h/6.0*(press[0] + 4.0*press[1] + press[2])).sum()
        offset, along, _ = self.hole.foot(y[-1:, 0:3], self.arc[-1:])
        aside = y[-1, 6:9] - (y[-1, 6:9] @ along[0])*along[0]
        tilt = y[-1, 3:6] - (y[-1, 3:6] @ along[0])*along[0]
        bending = [np.linalg.norm(np.cross(m[:, 9:12], m[:, 3:6]), axis=1) for m in (y[:-1], middle, y[1:])]
        return {"hook load": y[0, 6:9] @ self.ends[1]/1.0e3, "torque": -(y[0, 9:12] @ y[0, 3:6])/1.0e3,
                "contact": contact/1.0e3, "moment": max(b.max() for b in bending)/1.0e3,
                "von Mises": max(self.stress(state) for state in (y[:-1], middle, y[1:]))/1.0e6,
                "side force": np.linalg.norm(aside)/1.0e3, "tilt": np.degrees(np.arcsin(np.linalg.norm(tilt)))}

    def weight_along(self):
        """Axial weight in mud [kN]."""
        return (self.weight*np.diff(self.hole.on_axis(self.s)[0][:, 2])).sum()/1.0e3

    def stress(self, y):
        """Largest von Mises stress at states of the intervals [Pa]; mud at rest inside and outside."""
        outer, inner = 0.5*self.od, 0.5*self.bore
        area, inertia = np.pi*(outer**2 - inner**2), 0.25*np.pi*(outer**4 - inner**4)
        pressure = self.case["mud"]*GRAVITY*y[:, 2]
        tension = dot(y[:, 6:9], y[:, 3:6])[:, 0]/area - pressure        # true: less what the mud presses on the ends
        bending = np.linalg.norm(np.cross(y[:, 9:12], y[:, 3:6]), axis=1)/inertia
        shear = abs(dot(y[:, 9:12], y[:, 3:6])[:, 0])/(2.0*inertia)
        largest = 0.0
        for radius in (outer, inner):
            for sign in (1.0, -1.0):
                normal = tension + sign*bending*radius + pressure        # beside the pressure all round
                largest = max(largest, np.sqrt(normal**2 + 3.0*(shear*radius)**2).max())
        return largest
