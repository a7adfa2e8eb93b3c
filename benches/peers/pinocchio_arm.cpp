// Pinocchio's rnea and crba on the arm of arm.txt, in C++ loops over random states; and what they answer.
//   pinocchio_arm arm.txt          one JSON line: microseconds a call, process CPU, least and median of rounds
//   pinocchio_arm arm.txt print    torques and mass matrix of the first states, 17 digits
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

#include <time.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

namespace pin = pinocchio;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

static const int AXES = 6, STATES = 256, CALLS = 20000, ROUNDS = 31;

static pin::Model read(const char *path) {
  pin::Model model;
  model.gravity.linear(Vector3d(0, 0, -9.81));
  std::ifstream file(path);
  std::string line;
  pin::JointIndex parent = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream in(line);
    double turns, m, xx, xy, xz, yy, yz, zz;
    Vector3d p, c;
    in >> turns >> p[0] >> p[1] >> p[2] >> m >> c[0] >> c[1] >> c[2] >> xx >> xy >> xz >> yy >> yz >> zz;
    Matrix3d R = Matrix3d::Identity(), J;
    if (turns != 0) R << 1, 0, 0, 0, 0, -turns, 0, turns, 0;
    J << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    parent = model.addJoint(parent, pin::JointModelRZ(), pin::SE3(R, p), "joint" + std::to_string(model.njoints));
    model.appendBodyToJoint(parent, pin::Inertia(m, c, J), pin::SE3::Identity());
  }
  return model;
}

// The generator of the Rust bench: the same states.
static std::uint64_t seed = 1;
static double draw(double most) {
  seed = seed * 6364136223846793005ull + 1442695040888963407ull;
  return most * (2.0 * (double(seed >> 11) / 9007199254740992.0) - 1.0);
}

static double now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

template <class F>
static void measure(const char *name, F call, bool last = false) {
  std::vector<double> us;
  for (int round = 0; round < ROUNDS; round++) {
    double start = now();
    for (int i = 0; i < CALLS; i++) call(i % STATES);
    us.push_back((now() - start) / CALLS * 1e6);
  }
  std::sort(us.begin(), us.end());
  std::printf("\"%s_us\": [%.5f, %.5f]%s", name, us[0], us[ROUNDS / 2], last ? "" : ", ");
}

int main(int count, char **arguments) {
  if (count < 2) return 2;
  pin::Model model = read(arguments[1]);
  pin::Data data(model);
  std::vector<VectorXd> q, v, a;
  for (int s = 0; s < STATES; s++) {
    VectorXd x(AXES), y(AXES), z(AXES);
    for (int i = 0; i < AXES; i++) x[i] = draw(3.0), y[i] = draw(2.0), z[i] = draw(5.0);
    q.push_back(x), v.push_back(y), a.push_back(z);
  }
  if (count > 2 && !std::strcmp(arguments[2], "print")) {
    for (int s = 0; s < 16; s++) {
      pin::rnea(model, data, q[s], v[s], a[s]);
      pin::crba(model, data, q[s], pin::Convention::LOCAL);
      for (int i = 0; i < AXES; i++) std::printf("%.17g ", data.tau[i]);
      for (int i = 0; i < AXES; i++)
        for (int j = 0; j <= i; j++) std::printf("%.17g ", data.M(j, i));
      std::printf("\n");
    }
    return 0;
  }
  double sum = 0;
  std::printf("{");
  measure("rnea", [&](int s) { sum += pin::rnea(model, data, q[s], v[s], a[s])[0]; });
  measure("crba_local", [&](int s) { sum += pin::crba(model, data, q[s], pin::Convention::LOCAL)(0, 0); });
  measure("crba_world", [&](int s) { sum += pin::crba(model, data, q[s], pin::Convention::WORLD)(0, 0); }, true);
  std::printf("}\n");
  return sum == 0.5;
}
